// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/samples/Paint.h"
#include "core/samples/RandomFields.h"
#include "core/samples/Recipes.h"

namespace txn {

Image makeSand(Size size, Seed seed) {
    RandomFields fields(size, seed);
    const Field relief = fields.draw(lit(fractal(0.6, 60, 0.5)));
    const Field grain = fields.draw(grains(5.0, 0.65));
    const Field mineral = fields.draw(blobs(1.0));
    const Field specks = fields.draw(blobs(0.85));
    const Field damp = fields.draw(fractal(0.8, 150));

    return paint(size, [&](const Pixel& p) {
        const std::size_t i = p.index;
        const float light = 0.045F * relief[i] + 0.062F * grain[i] + 0.012F * damp[i];
        const float dark = smoothStep(1.9F, 3.0F, specks[i]);
        return Color{0.79F, 0.68F, 0.52F} + Color{1.0F, 0.98F, 0.90F} * light +
               Color{0.014F, -0.001F, -0.016F} * mineral[i] + Color{-0.30F, -0.29F, -0.24F} * dark;
    });
}

} // namespace txn
