// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/samples/Paint.h"
#include "core/samples/RandomFields.h"
#include "core/samples/Recipes.h"

namespace txn {

Image makeMetal(Size size, Seed seed) {
    RandomFields fields(size, seed);
    const Field brush = fields.draw(streaks(140, 0.45));
    const Field strokes = fields.draw(streaks(45, 0.7));
    const Field scratches = fields.draw(streaks(18, 0.45));
    const Field bands = fields.draw(streaks(220, 5));
    const Field sheen = fields.draw(streaks(110, 70));

    return paint(size, [&](const Pixel& p) {
        const std::size_t i = p.index;
        const float light =
            0.040F * brush[i] + 0.026F * strokes[i] + 0.016F * scratches[i] + 0.010F * bands[i];
        return Color{0.655F, 0.665F, 0.680F} + Color{1.0F, 1.0F, 0.99F} * light +
               Color{0.026F, 0.025F, 0.023F} * sheen[i];
    });
}

} // namespace txn
