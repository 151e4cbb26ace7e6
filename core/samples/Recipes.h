// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Random.h"
#include "core/image/Image.h"

namespace txn {

// One recipe a file, called by makeSample only. All are RGB, Encoded and periodic, and take any
// size from 16 x 16 on.

[[nodiscard]] Image makeWood(Size size, Seed seed);
[[nodiscard]] Image makeStone(Size size, Seed seed);
[[nodiscard]] Image makeSand(Size size, Seed seed);
[[nodiscard]] Image makeRust(Size size, Seed seed);
[[nodiscard]] Image makeMetal(Size size, Seed seed);
[[nodiscard]] Image makeCloth(Size size, Seed seed);
[[nodiscard]] Image makeLeather(Size size, Seed seed);

} // namespace txn
