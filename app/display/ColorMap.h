// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/image/Image.h"

#include <QImage>

namespace txn::app {

/// One channel in false colours, from value low (dark blue) to high (yellow): evenly graded to the
/// eye and safe for the colour-blind (the map is viridis).
[[nodiscard]] QImage falseColors(const Image& image, double low, double high);

} // namespace txn::app
