// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/CancelToken.h"
#include "core/base/Result.h"
#include "core/image/Image.h"

#include <utility>

namespace txn {

/// The part of the image inside rect. Errors: InvalidArgument where rect is empty or not wholly
/// inside.
[[nodiscard]] Result<Image> crop(const Image& image, const Rect& rect);

/// The middle of the image, no larger than that.
[[nodiscard]] Image middlePart(const Image& image, Size atMost);

/// Left and right, or top and bottom; the middle line of an odd side is left out. At least 2 pixels
/// along that side.
[[nodiscard]] std::pair<Image, Image> halves(const Image& image, bool leftRight);

/// The image turned about its center and cropped to the largest upright rectangle that lies wholly
/// inside the turned picture. Multiples of 90 degrees move samples and change none; other angles
/// resample with a Lanczos filter of radius 3, which may overshoot by some percent at sharp edges.
/// Errors: InvalidArgument for an angle that is not finite or where nothing is left; Cancelled.
[[nodiscard]] Result<Image>
rotated(const Image& image, double degreesCounterClockwise, const CancelToken& cancel = {});

/// The image upright, given how it is stored as EXIF numbers it: 1 is upright, 2 to 8 the mirrored
/// and turned ones, anything else counts as 1.
[[nodiscard]] Image upright(Image image, int exifOrientation);

} // namespace txn
