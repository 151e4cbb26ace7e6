// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/image/Image.h"

#include <functional>
#include <initializer_list>
#include <vector>

namespace txn {

/// Encoded red, green and blue, 1 is white.
struct Color {
    float r = 0.0F;
    float g = 0.0F;
    float b = 0.0F;

    friend Color operator+(Color a, Color b) { return {a.r + b.r, a.g + b.g, a.b + b.b}; }
    friend Color operator-(Color a, Color b) { return {a.r - b.r, a.g - b.g, a.b - b.b}; }
    friend Color operator*(Color a, float s) { return {a.r * s, a.g * s, a.b * s}; }
    bool operator==(const Color&) const = default;
};

/// a at 0, b at 1.
[[nodiscard]] inline Color mix(Color a, Color b, float t) {
    return a + (b - a) * t;
}

/// 0 below from, 1 above to, smooth in between.
[[nodiscard]] float smoothStep(float from, float to, float value);

/// Colours at equal steps from 0 to 1, straight in between and beyond the ends.
class ColorRamp {
  public:
    /// At least two.
    ColorRamp(std::initializer_list<Color> colors);

    [[nodiscard]] Color at(float t) const;

  private:
    std::vector<Color> m_colors;
};

struct Pixel {
    int x = 0;
    int y = 0;
    std::size_t index = 0; ///< into a row-major field
};

/// An RGB image, each pixel painted by itself, on all cores. Colours near or beyond black and white
/// are bent softly into [0, 1], as film does, instead of being cut off.
[[nodiscard]] Image paint(Size size, const std::function<Color(const Pixel&)>& colorAt);

} // namespace txn
