// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/image/Image.h"

namespace txn {

/// The whole image, shrunk until it fits, its proportions kept; what fits already stays as it is.
/// Samples are averaged by a smooth filter as wide as the new pixels. Errors: InvalidArgument for
/// an empty image or size. Thread-safe.
[[nodiscard]] Result<Image> shrunkTo(const Image& image, Size atMost);

} // namespace txn
