// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/samples/Paint.h"
#include "core/samples/RandomFields.h"
#include "core/samples/Recipes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace txn {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr double kThreadPx = 8.0;

/// An even number of threads, so that over and under match where the image tiles.
int threadsAcross(int lengthPx) {
    return 2 * std::max(1, static_cast<int>(std::lround(lengthPx / (2.0 * kThreadPx))));
}

/// The yarn of one direction at a pixel.
struct Yarn {
    float height; ///< 1 on the crown where it crosses over, below 0 in a gap
    float across; ///< -1..1 from edge to edge
};

/// across, along: position in threads, >= 0; halfWidth in threads; phase: 0 or 1, which of the
/// threads cross over first.
Yarn yarnAt(float across, float along, float halfWidth, int phase) {
    const float thread = std::floor(across);
    const float u = (across - thread - 0.5F) / halfWidth;
    const float sign = (static_cast<int>(thread) + phase) % 2 == 0 ? 1.0F : -1.0F;
    const float round = 1.0F - u * u;
    return {round > 0.0F ? 0.55F * std::sqrt(round) + 0.40F * sign * std::sin(kPi * along) : -1.0F,
            u};
}

} // namespace

Image makeCloth(Size size, Seed seed) {
    RandomFields fields(size, seed);
    // Of the threads that run down and of those that run across: sway, thickness, colour, fibres.
    const Field swayDown = fields.draw(streaks(3, 30));
    const Field swayAcross = fields.draw(streaks(30, 3));
    const Field thickDown = fields.draw(streaks(2.5, 22));
    const Field thickAcross = fields.draw(streaks(22, 2.5));
    const Field dyeDown = fields.draw(streaks(2.5, 120));
    const Field dyeAcross = fields.draw(streaks(120, 2.5));
    const Field fiberDown = fields.draw(streaks(0.5, 3));
    const Field fiberAcross = fields.draw(streaks(3, 0.5));

    const float perPixelX =
        static_cast<float>(threadsAcross(size.width)) / static_cast<float>(size.width);
    const float perPixelY =
        static_cast<float>(threadsAcross(size.height)) / static_cast<float>(size.height);
    return paint(size, [&](const Pixel& p) {
        const std::size_t i = p.index;
        // 8 threads on, where sway cannot make the position negative.
        const float x = (static_cast<float>(p.x) + 0.5F) * perPixelX + 0.07F * swayDown[i] + 8.0F;
        const float y = (static_cast<float>(p.y) + 0.5F) * perPixelY + 0.07F * swayAcross[i] + 8.0F;
        const Yarn down = yarnAt(x, y, 0.46F + 0.05F * thickDown[i], 0);
        const Yarn across = yarnAt(y, x, 0.46F + 0.05F * thickAcross[i], 1);
        const bool isDown = down.height > across.height;
        const Yarn& top = isDown ? down : across;
        const float fiber = isDown ? fiberDown[i] : fiberAcross[i];
        const float dye = isDown ? dyeDown[i] : dyeAcross[i];
        const float gap = smoothStep(-0.35F, 0.55F, top.height);
        const float light = 0.42F + 0.58F * gap - 0.05F * top.across;
        const Color yarn = Color{0.72F, 0.66F, 0.56F} + Color{0.05F, 0.048F, 0.043F} * dye +
                           Color{0.045F, 0.044F, 0.040F} * fiber;
        return yarn * light;
    });
}

} // namespace txn
