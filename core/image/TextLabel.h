// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/image/Image.h"

#include <string_view>

namespace txn {

/// Draws one line of text into every channel, antialiased, in the font DejaVu Sans. x and baselineY
/// are where the first letter stands; heightPx is the font's nominal size. What falls outside the
/// image is cut off. Errors: InvalidArgument for heightPx < 1; Unsupported where the font is
/// missing.
[[nodiscard]] Result<void>
drawText(Image& image, int x, int baselineY, int heightPx, std::string_view text, float value);

/// How far the text reaches to the right of x, in pixels. Errors as above.
[[nodiscard]] Result<int> textWidthPx(std::string_view text, int heightPx);

} // namespace txn
