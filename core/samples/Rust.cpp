// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/samples/Paint.h"
#include "core/samples/RandomFields.h"
#include "core/samples/Recipes.h"

#include <algorithm>

namespace txn {

Image makeRust(Size size, Seed seed) {
    RandomFields fields(size, seed);
    // Scale, the dark layered oxide, shows where the powdery orange one is thin.
    const Field powder = fields.draw(fractal(0.12, 55, 0.45));
    const Field yellow = fields.draw(fractal(0.3, 80, 0.6));
    const Field pits = fields.draw(grains(9, 0.6));
    const Field relief = fields.draw(lit(fractal(0.1, 12, 0.45)));

    const ColorRamp ramp{{0.16F, 0.11F, 0.095F},
                         {0.26F, 0.165F, 0.13F},
                         {0.42F, 0.235F, 0.145F},
                         {0.58F, 0.335F, 0.19F},
                         {0.73F, 0.46F, 0.26F}};
    return paint(size, [&](const Pixel& p) {
        const std::size_t i = p.index;
        const float pit = smoothStep(1.0F, 2.6F, pits[i] - 0.6F * powder[i]);
        const float tone = 0.62F + 0.15F * powder[i] - 0.30F * pit;
        const Color color = ramp.at(std::max(tone, 0.0F)) * (1.0F + 0.12F * relief[i]);
        return Color{color.r * (1.0F + 0.04F * yellow[i]),
                     color.g * (1.0F + 0.10F * yellow[i]),
                     color.b * (1.0F + 0.10F * yellow[i])};
    });
}

} // namespace txn
