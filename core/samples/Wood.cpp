// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/samples/Paint.h"
#include "core/samples/RandomFields.h"
#include "core/samples/Recipes.h"

namespace txn {

Image makeWood(Size size, Seed seed) {
    RandomFields fields(size, seed);
    // All lines of the grain sway together.
    Field sway = fields.draw(streaks(90, 130));
    for (float& v : sway)
        v *= 4.0F;
    const auto lines = [&](const SpectralDensity& density) {
        return shiftedAcross(fields.draw(density), size, sway);
    };
    const Field grain = lines(grainLines(
        {.hurst = 0.2, .spread = 0.012, .outerPx = 45, .innerPx = 0.4, .lengthPx = 200}));
    const Field fibers = lines(streaks(0.4, 18));
    const Field pores = lines(streaks(0.45, 6));
    const Field dust = fields.draw(blobs(0.5));
    const Field hue = lines(streaks(14, 120));
    const Field figure = fields.draw(streaks(14, 20));

    const ColorRamp ramp{{0.40F, 0.25F, 0.14F},
                         {0.58F, 0.39F, 0.23F},
                         {0.72F, 0.52F, 0.33F},
                         {0.82F, 0.64F, 0.45F}};
    return paint(size, [&](const Pixel& p) {
        const std::size_t i = p.index;
        const float tone =
            0.56F + 0.13F * grain[i] + 0.06F * fibers[i] + 0.02F * figure[i] + 0.03F * dust[i];
        const float pore = smoothStep(0.9F, 2.6F, pores[i] - 0.3F * grain[i]);
        const Color warmth = Color{0.005F, -0.003F, -0.004F} * hue[i];
        return ramp.at(tone - 0.36F * pore) + warmth;
    });
}

} // namespace txn
