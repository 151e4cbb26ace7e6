// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/samples/Paint.h"
#include "core/samples/RandomFields.h"
#include "core/samples/Recipes.h"

#include <algorithm>
#include <cmath>
#include <tbb/parallel_for.h>

namespace txn {
namespace {

constexpr double kPebblePx = 10.0;

/// One point in each cell of a wrapped grid.
class Pebbles {
  public:
    Pebbles(Size size, Seed seed)
        : m_columns(std::max(3, static_cast<int>(std::lround(size.width / kPebblePx)))),
          m_rows(std::max(3, static_cast<int>(std::lround(size.height / kPebblePx)))),
          m_perPixelX(static_cast<float>(m_columns) / static_cast<float>(size.width)),
          m_perPixelY(static_cast<float>(m_rows) / static_cast<float>(size.height)), m_seed(seed) {}

    /// How far the place (pixels) is from the nearest crease, 0 on it, in pebbles.
    [[nodiscard]] float depth(float xPx, float yPx) const {
        const float x = xPx * m_perPixelX;
        const float y = yPx * m_perPixelY;
        const int column = static_cast<int>(std::floor(x));
        const int row = static_cast<int>(std::floor(y));
        float nearest = 9.0F;
        float second = 9.0F;
        for (int dy = -1; dy <= 1; ++dy) {
            for (int dx = -1; dx <= 1; ++dx) {
                const auto h =
                    hash4(wrap(column + dx, m_columns), wrap(row + dy, m_rows), 1, m_seed.value);
                const float px = static_cast<float>(column + dx) + jitter(h[0]) - x;
                const float py = static_cast<float>(row + dy) + jitter(h[1]) - y;
                const float distance = std::sqrt(px * px + py * py);
                second = std::min(second, std::max(nearest, distance));
                nearest = std::min(nearest, distance);
            }
        }
        return second - nearest;
    }

  private:
    static std::uint32_t wrap(int index, int count) {
        return static_cast<std::uint32_t>((index % count + count) % count);
    }
    static float jitter(std::uint32_t bits) {
        return 0.15F + 0.70F * static_cast<float>(toUnitOpen(bits));
    }

    int m_columns;
    int m_rows;
    float m_perPixelX;
    float m_perPixelY;
    Seed m_seed;
};

} // namespace

Image makeLeather(Size size, Seed seed) {
    RandomFields fields(size, seed);
    const Field bendX = fields.draw(blobs(5));
    const Field bendY = fields.draw(blobs(5));
    const Field stretch = fields.draw(fractal(0.5, 25, 1));
    const Field skin = fields.draw(fractal(0.3, 5, 0.5));
    const Field dye = fields.draw(fractal(0.8, 80, 2));

    const Pebbles pebbles(size, seed);
    Field height(size.area());
    tbb::parallel_for(0, size.height, [&](int y) {
        for (int x = 0; x < size.width; ++x) {
            const std::size_t i =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) +
                static_cast<std::size_t>(x);
            const float depth = pebbles.depth(static_cast<float>(x) + 1.8F * bendX[i],
                                              static_cast<float>(y) + 1.8F * bendY[i]);
            height[i] =
                1.0F - std::exp(-6.0F * depth * depth) + 0.05F * skin[i] + 0.10F * stretch[i];
        }
    });

    return paint(size, [&](const Pixel& p) {
        const std::size_t i = p.index;
        const std::size_t above = p.y > 0 ? i - static_cast<std::size_t>(size.width)
                                          : i + size.area() - static_cast<std::size_t>(size.width);
        const std::size_t left = p.x > 0 ? i - 1 : i + static_cast<std::size_t>(size.width) - 1;
        const float slope = 0.5F * (height[i] - height[left]) + 0.7F * (height[i] - height[above]);
        const float light = 0.72F + 0.30F * height[i] + 0.45F * slope;
        const Color color = Color{0.45F, 0.27F, 0.17F} + Color{0.025F, 0.018F, 0.012F} * dye[i];
        return color * light + Color{0.22F, 0.22F, 0.22F} * std::max(0.0F, slope);
    });
}

} // namespace txn
