// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gaussian/WhiteNoise.h"

#include <tbb/parallel_for.h>

namespace txn {

Image whiteNoise(Size size, int channels, Seed seed) {
    Image noise(size, channels);
    tbb::parallel_for(0, size.height * channels, [&](int index) {
        const int c = index / size.height;
        const int y = index % size.height;
        const auto row = noise.row(c, y);
        for (std::size_t x = 0; x < row.size(); x += 4) {
            const auto h = hash4(static_cast<std::uint32_t>(x / 4),
                                 static_cast<std::uint32_t>(y),
                                 static_cast<std::uint32_t>(c),
                                 seed.value);
            const auto first = gaussianPair(h[0], h[1]);
            const auto second = gaussianPair(h[2], h[3]);
            const double values[4] = {first.first, first.second, second.first, second.second};
            for (std::size_t i = 0; i < 4 && x + i < row.size(); ++i)
                row[x + i] = static_cast<float>(values[i]);
        }
    });
    return noise;
}

} // namespace txn
