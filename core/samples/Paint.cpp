// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/samples/Paint.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <tbb/parallel_for.h>

namespace txn {
namespace {

/// Identity down to the toe, from there an exponential to 0; the same at white.
float bend(float v) {
    constexpr float kToe = 0.06F;
    if (v < kToe)
        return kToe * std::exp((v - kToe) / kToe);
    if (v > 1.0F - kToe)
        return 1.0F - kToe * std::exp((1.0F - kToe - v) / kToe);
    return v;
}

} // namespace

float smoothStep(float from, float to, float value) {
    const float t = std::clamp((value - from) / (to - from), 0.0F, 1.0F);
    return t * t * (3.0F - 2.0F * t);
}

ColorRamp::ColorRamp(std::initializer_list<Color> colors) : m_colors(colors) {
    assert(m_colors.size() >= 2);
}

Color ColorRamp::at(float t) const {
    const auto last = static_cast<float>(m_colors.size() - 1);
    const float place = t * last;
    const float index = std::floor(std::clamp(place, 0.0F, last - 1.0F));
    const auto i = static_cast<std::size_t>(index);
    return mix(m_colors[i], m_colors[i + 1], place - index);
}

Image paint(Size size, const std::function<Color(const Pixel&)>& colorAt) {
    Image image(size, 3);
    tbb::parallel_for(0, size.height, [&](int y) {
        const auto red = image.row(0, y);
        const auto green = image.row(1, y);
        const auto blue = image.row(2, y);
        const auto start = static_cast<std::size_t>(y) * red.size();
        for (std::size_t x = 0; x < red.size(); ++x) {
            const Color color = colorAt({static_cast<int>(x), y, start + x});
            red[x] = bend(color.r);
            green[x] = bend(color.g);
            blue[x] = bend(color.b);
        }
    });
    return image;
}

} // namespace txn
