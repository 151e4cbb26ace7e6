// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"

#include <QString>

namespace txn::app {

/// What went wrong, for the message bar: in the window's language what happened and what to do,
/// then the details, which core tells in English and which name the file.
[[nodiscard]] QString inWords(const Error& error);

} // namespace txn::app
