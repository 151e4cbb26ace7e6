// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/image/Image.h"

namespace txn {

/// The sRGB transfer curve (IEC 61966-2-1). Odd, so that negative values survive, and the same
/// formula beyond 1. NaN gives NaN. Round trips are within 1e-6 of max(1, |value|).
[[nodiscard]] float linearFromEncoded(float encoded);
[[nodiscard]] float encodedFromLinear(float linear);

/// The image with its samples taken through the curve; unchanged where it is Linear (Encoded)
/// already.
[[nodiscard]] Image toLinear(Image image);
[[nodiscard]] Image toEncoded(Image image);

} // namespace txn
