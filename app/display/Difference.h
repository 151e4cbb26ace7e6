// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>

namespace txn::app {

/// a - b, eight times, around mid grey; where either is transparent, mid grey. Both of the same
/// size and ARGB32, premultiplied.
[[nodiscard]] QImage difference(const QImage& a, const QImage& b);

} // namespace txn::app
