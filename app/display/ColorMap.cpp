// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/display/ColorMap.h"

#include "app/memory/NewImage.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace txn::app {
namespace {

/// Viridis (S. van der Walt and N. Smith, CC0) at even steps.
constexpr std::array<std::array<int, 3>, 9> kViridis{{{68, 1, 84},
                                                      {71, 44, 122},
                                                      {59, 81, 139},
                                                      {44, 113, 142},
                                                      {33, 144, 141},
                                                      {39, 173, 129},
                                                      {92, 200, 99},
                                                      {170, 220, 50},
                                                      {253, 231, 37}}};

QRgb viridis(double t) {
    const double place = std::clamp(t, 0.0, 1.0) * (kViridis.size() - 1);
    const auto i = std::min(static_cast<std::size_t>(place), kViridis.size() - 2);
    const double f = place - static_cast<double>(i);
    const auto mix = [&](std::size_t c) {
        return static_cast<int>(std::lround(kViridis[i][c] * (1.0 - f) + kViridis[i + 1][c] * f));
    };
    return qRgb(mix(0), mix(1), mix(2));
}

} // namespace

QImage falseColors(const Image& image, double low, double high) {
    std::array<QRgb, 256> table{};
    for (std::size_t i = 0; i < table.size(); ++i)
        table[i] = viridis(static_cast<double>(i) / (table.size() - 1));
    QImage picture = newImage({image.width(), image.height()}, QImage::Format_RGB32);
    const double scale = 255.0 / (high - low);
    for (int y = 0; y < image.height(); ++y) {
        const auto row = image.row(0, y);
        auto* out = reinterpret_cast<QRgb*>(picture.scanLine(y));
        for (std::size_t x = 0; x < row.size(); ++x) {
            const double v = (static_cast<double>(row[x]) - low) * scale;
            out[x] = table[v > 0.0 ? static_cast<std::size_t>(std::min(v, 255.0)) : 0];
        }
    }
    return picture;
}

} // namespace txn::app
