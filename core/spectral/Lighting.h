// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/CancelToken.h"
#include "core/base/Result.h"
#include "core/image/Image.h"

namespace txn {

/// Evens out the lighting of a photograph: subtracts everything smoother than a Gaussian blur of
/// the given radius (its standard deviation, in pixels), keeping each channel's mean. The image is
/// continued by mirrors, so borders do not darken.
/// Errors: InvalidArgument for a radius that is not positive; Cancelled.
[[nodiscard]] Result<Image>
flattenLighting(const Image& image, double radiusPx, const CancelToken& cancel = {});

} // namespace txn
