// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/noise/SpotNoise.h"
#include "tests/helpers/Gl.h"

#include <cmath>
#include <functional>
#include <utility>

namespace txn::test {

/// What a point of the picture shows, in pixels from its top left corner: the plane is turned
/// clockwise, so that the picture's axes turn counterclockwise on it.
inline std::pair<double, double> planePoint(const PlaneView& view, Size size, double x, double y) {
    const double u = (x - 0.5 * size.width) / view.zoom;
    const double v = (y - 0.5 * size.height) / view.zoom;
    const double cosine = std::cos(view.rotation);
    const double sine = std::sin(view.rotation);
    return {view.centerX + cosine * u + sine * v, view.centerY - sine * u + cosine * v};
}

/// A picture whose pixels are means over n x n points; where(x, y) says what a point shows, or
/// nothing.
using Where = std::function<std::optional<std::pair<double, double>>(double x, double y)>;
inline Image reference(const Mixture& mixture,
                       const NoiseParams& params,
                       Size size,
                       const Where& where,
                       int n = 1,
                       float background = 0.0F) {
    const SpotNoise noise(mixture, params);
    const int channels = mixture.textons.front().channels();
    Image image(size, 4);
    std::vector<double> values(static_cast<std::size_t>(channels));
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            for (int k = 0; k < n * n; ++k) {
                const auto point = where(x + (k % n + 0.5) / n, y + (k / n + 0.5) / n);
                if (point)
                    noise.evaluate(point->first, point->second, values);
                for (int c = 0; c < 4; ++c) {
                    const auto shown = shownChannel(channels, c);
                    const double value = c == 3 && (!shown || !point) ? 1.0
                                         : !point ? static_cast<double>(background)
                                         : shown  ? values[static_cast<std::size_t>(*shown)]
                                                  : 0.0;
                    image.at(x, y, c) += static_cast<float>(value / (n * n));
                }
            }
        }
    }
    return image;
}

} // namespace txn::test
