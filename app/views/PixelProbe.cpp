// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/PixelProbe.h"

#include "core/image/ColorTransfer.h"

#include <QColor>
#include <algorithm>
#include <cmath>

namespace txn::app {

ProbeInfo probePixel(const Image& image, QPoint pixel, QPoint place) {
    ProbeInfo info;
    info.x = place.x();
    info.y = place.y();
    const bool inside =
        pixel.x() >= 0 && pixel.y() >= 0 && pixel.x() < image.width() && pixel.y() < image.height();
    if (!inside)
        return info;
    const bool linear = image.transfer() == Transfer::Linear;
    for (int c = 0; c < image.channels(); ++c) {
        const float v = image.at(pixel.x(), pixel.y(), c);
        info.encoded.push_back(static_cast<double>(linear ? encodedFromLinear(v) : v));
        info.linear.push_back(static_cast<double>(linear ? v : linearFromEncoded(v)));
    }
    const std::size_t count = info.encoded.size();
    if (count == 1 || count == 3) {
        const auto byte = [&](std::size_t c) {
            return static_cast<int>(
                std::lround(std::clamp(info.encoded[std::min(c, count - 1)], 0.0, 1.0) * 255.0));
        };
        info.hex = QColor(byte(0), byte(1), byte(2)).name().toUpper();
    }
    return info;
}

} // namespace txn::app
