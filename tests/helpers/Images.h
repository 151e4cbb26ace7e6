// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/gaussian/GaussianModel.h"
#include "core/image/Image.h"
#include "tests/helpers/Numbers.h"

#include <limits>
#include <numbers>
#include <vector>

namespace txn::test {

/// Independent values around 0.5, every channel and pixel different.
inline Image randomImage(Size size, int channels, std::uint64_t seed, double contrast = 0.2) {
    TestRandom random(seed);
    Image image(size, channels);
    for (float& v : image.samples())
        v = static_cast<float>(0.5 + contrast * random.gaussian());
    return image;
}

/// A small picture with structure: waves, correlated channels, a slope (so that it does not tile)
/// and noise. Values about 0.2 to 0.8.
inline Image texturedImage(Size size, int channels, std::uint64_t seed) {
    TestRandom random(seed);
    Image image(size, channels);
    std::vector<double> phase;
    for (int c = 0; c < channels; ++c)
        phase.push_back(random.uniform(0.0, 2.0));
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const double shared = random.gaussian();
            for (int c = 0; c < channels; ++c) {
                const double wave =
                    std::sin(0.9 * x + 0.35 * y + phase[static_cast<std::size_t>(c)]) +
                    0.6 * std::cos(0.25 * x - 0.7 * y * (1 + c % 2));
                const double slope = 0.1 * x / size.width - 0.07 * y / size.height;
                image.at(x, y, c) = static_cast<float>(0.5 + 0.08 * wave + slope + 0.04 * shared +
                                                       0.03 * random.gaussian());
            }
        }
    }
    return image;
}

/// Largest difference of two samples; infinite for images that do not fit together.
inline double imageDistance(const Image& a, const Image& b) {
    if (a.empty() || a.size() != b.size() || a.channels() != b.channels())
        return std::numeric_limits<double>::infinity();
    return largestDifference(a.samples(), b.samples());
}

inline Exemplar exemplarOf(Image image) {
    return *makeExemplar(std::move(image), "test");
}

inline GaussianModel texturedModel(Size size, int channels, std::uint64_t seed) {
    return GaussianModel(exemplarOf(texturedImage(size, channels, seed)));
}

} // namespace txn::test
