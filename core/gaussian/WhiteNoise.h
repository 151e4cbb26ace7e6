// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Random.h"
#include "core/image/Image.h"

namespace txn {

/// Independent standard Gaussian values, H x W x C. Each value depends on its place, channel and
/// seed only, so the result is the same for any number of threads.
[[nodiscard]] Image whiteNoise(Size size, int channels, Seed seed);

} // namespace txn
