// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/image/Image.h"

#include <cstdint>
#include <span>

namespace txn {

/// Takes an encoded image of 1 or 3 channels from an embedded ICC profile (grey or RGB) to sRGB,
/// relative colorimetric. False, and the samples untouched, where the profile is sRGB already to
/// within 1/1024, is broken, or is not for that number of channels. Thread-safe.
[[nodiscard]] bool convertToSrgb(Image& image, std::span<const std::uint8_t> profile);

} // namespace txn
