// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/samples/Paint.h"
#include "core/samples/RandomFields.h"
#include "core/samples/Recipes.h"

#include <array>
#include <cmath>

namespace txn {
namespace {

/// One kind of crystal. A field of its own says how strongly it wants each pixel.
struct Mineral {
    Color color;
    double sizePx;   ///< of its crystals
    float abundance; ///< added to the field
    float shade;     ///< lightness from crystal to crystal, standard deviation
};

constexpr std::array kMinerals{
    Mineral{{0.73F, 0.70F, 0.66F}, 26.0, 0.55F, 0.045F},    // white feldspar
    Mineral{{0.67F, 0.57F, 0.51F}, 30.0, 0.15F, 0.045F},    // pink feldspar
    Mineral{{0.54F, 0.52F, 0.49F}, 20.0, 0.30F, 0.060F},    // quartz, glassy grey
    Mineral{{0.25F, 0.235F, 0.225F}, 13.0, -0.45F, 0.035F}, // black mica
};

} // namespace

Image makeStone(Size size, Seed seed) {
    RandomFields fields(size, seed);
    std::array<Field, kMinerals.size()> wants;
    for (std::size_t k = 0; k < kMinerals.size(); ++k)
        wants[k] = fields.draw(fractal(0.75, kMinerals[k].sizePx, 0.4));
    const Field facets = fields.draw(fractal(0.3, 10));
    const Field dust = fields.draw(blobs(0.6));

    return paint(size, [&](const Pixel& p) {
        const std::size_t i = p.index;
        // The strongest mineral takes the pixel; a narrow softmax keeps the borders a pixel wide.
        constexpr float kSharpness = 9.0F;
        Color color;
        float total = 0.0F;
        float shade = 0.0F;
        for (std::size_t k = 0; k < kMinerals.size(); ++k) {
            const Mineral& mineral = kMinerals[k];
            const float weight = std::exp(kSharpness * (wants[k][i] + mineral.abundance));
            color = color + mineral.color * weight;
            shade += mineral.shade * weight;
            total += weight;
        }
        const float light = (shade / total) * facets[i] + 0.018F * dust[i];
        return color * (1.0F / total) + Color{1.0F, 0.97F, 0.94F} * light;
    });
}

} // namespace txn
