// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/TextLabel.h"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include <algorithm>
#include <exception>
#include <string>
#include <vector>

namespace txn {
namespace {

constexpr const char* kFont = "DejaVuSans";

/// Where the ink of the text lies, relative to the start of its baseline.
Result<OIIO::ROI> inkArea(std::string_view text, int heightPx) {
    if (heightPx < 1)
        return Error{ErrorCode::InvalidArgument, "text must be at least one pixel high"};
    try {
        const OIIO::ROI area = OIIO::ImageBufAlgo::text_size(std::string(text), heightPx, kFont);
        if (area.defined())
            return area;
    } catch (const std::exception&) {
        // said below
    }
    return Error{ErrorCode::Unsupported,
                 "cannot draw text: the font DejaVu Sans was not found; install it"};
}

} // namespace

Result<void>
drawText(Image& image, int x, int baselineY, int heightPx, std::string_view text, float value) {
    if (text.empty())
        return {};
    const auto area = inkArea(text, heightPx);
    if (!area)
        return area.error();
    // The coverage is drawn apart, so that one pass serves every channel and any value.
    const int margin = 2;
    const int left = area->xbegin - margin;
    const int top = area->ybegin - margin;
    const int width = area->width() + 2 * margin;
    const int height = area->height() + 2 * margin;
    std::vector<float> coverage(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    try {
        OIIO::ImageBuf buffer(OIIO::ImageSpec(width, height, 1, OIIO::TypeFloat), coverage.data());
        if (!OIIO::ImageBufAlgo::render_text(buffer,
                                             -left,
                                             -top,
                                             std::string(text),
                                             heightPx,
                                             kFont))
            return Error{ErrorCode::Unsupported, "cannot draw text: " + buffer.geterror()};
    } catch (const std::exception& failure) {
        return Error{ErrorCode::Unsupported, std::string("cannot draw text: ") + failure.what()};
    }
    for (int c = 0; c < image.channels(); ++c) {
        for (int row = 0; row < height; ++row) {
            const int y = baselineY + top + row;
            if (y < 0 || y >= image.height())
                continue;
            for (int column = 0; column < width; ++column) {
                const int at = x + left + column;
                if (at < 0 || at >= image.width())
                    continue;
                const float amount = std::clamp(
                    coverage[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                             static_cast<std::size_t>(column)],
                    0.0F,
                    1.0F);
                float& sample = image.at(at, y, c);
                sample += amount * (value - sample);
            }
        }
    }
    return {};
}

Result<int> textWidthPx(std::string_view text, int heightPx) {
    if (text.empty())
        return 0;
    const auto area = inkArea(text, heightPx);
    if (!area)
        return area.error();
    return area->xend;
}

} // namespace txn
