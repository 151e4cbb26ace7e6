// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

namespace txn::app {

struct Project;

/// A small PNG of what the project is about: the part of the photo that it uses, or its texton.
/// Empty for one that has neither, or where there is no memory for it. Decodes the exemplar:
/// belongs into a job.
[[nodiscard]] QByteArray thumbnail(const Project& project);

} // namespace txn::app
