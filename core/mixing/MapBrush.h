// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/image/Image.h"
#include "core/mixing/MixingMap.h"

#include <optional>
#include <vector>

namespace txn {

/// What a stroke goes towards: a value of rho, the mean of what lies around, or A.
enum class BrushMode { Paint, Smooth, Erase };

/// Values outside their ranges count as the nearest within, NaN as 0.
struct Brush {
    double radius = 32.0;  ///< texels; 0: paints nothing, anything above is taken as 1 at least
    double hardness = 0.5; ///< 0 to 1: the share of the radius that is full; the edge is never
                           ///< narrower than a texel
    double strength = 1.0; ///< 0 to 1: how far a whole stroke goes at most
    BrushMode mode = BrushMode::Paint;
    float target = 1.0F; ///< of Paint: rho, 0 to 1

    bool operator==(const Brush&) const = default;
};

/// Strokes are mirrored about the map's middle: left and right, top and bottom, or both (four
/// copies).
struct Symmetry {
    bool acrossVertical = false;   ///< left and right
    bool acrossHorizontal = false; ///< top and bottom

    bool operator==(const Symmetry&) const = default;
};

/// One stroke, from press to release. Dabs are stamped along the path, a sixteenth of the radius
/// apart (less for large ones, at least a quarter of a texel), however often positions come. What
/// is covered is the largest of all dabs, so that crossing itself adds nothing: rho = lerp(before,
/// goal, strength * coverage). Smooth goes to means of `before` over about two thirds of the radius
/// (a tent). Not thread-safe.
class BrushStroke {
  public:
    /// before: the map as the stroke begins; one channel, 0 to 1. repeats: dabs reach across its
    /// borders, and means likewise; otherwise these see the map mirrored at its borders.
    BrushStroke(Image before, const Brush& brush, Symmetry symmetry, bool repeats);

    /// Goes on to (x, y), in texels: texel i is i to i + 1. pressure, 0 to 1 (1 for a mouse),
    /// scales the strength, and the radius from half of it to all. Positions may lie anywhere;
    /// those that are not finite are ignored, and a move of more than 16 times width + height
    /// begins anew there. map: of the size of `before`, as this stroke left it. Gives rectangles
    /// within the map, which may overlap: nothing changes outside.
    std::vector<Rect> moveTo(double x, double y, double pressure, Image& map);

  private:
    struct Point {
        double x = 0.0;
        double y = 0.0;
        double pressure = 0.0;
    };
    struct Box;
    void stampCopies(const Point& at, Image& map, std::vector<Box>& touched);
    [[nodiscard]] Box stamp(const Point& at, Image& map);

    Image m_before;
    Image m_goal; ///< where the stroke goes: means, or one row of a value
    Image m_mask; ///< what is covered, 0 to 1
    double m_radius;
    double m_hardness;
    float m_strength;
    Symmetry m_symmetry;
    bool m_repeats;
    double m_spacing; ///< of dabs
    std::optional<Point> m_last;
    double m_toNext = 0.0;        ///< way from there to the next dab
    std::vector<float> m_columns; ///< squared distances to the dab at work
};

/// rho everywhere; outside 0 to 1 the nearest within. NaN changes nothing.
void fillMap(Image& map, float rho);

/// A point of a map in texels: texel i is i to i + 1.
struct MapPoint {
    double x = 0.0;
    double y = 0.0;
};

// Gradients over the whole map, one channel. Values of rho outside 0 to 1 count as the nearest
// within. Where a number is not finite, or both points are one, nothing changes.

/// From rhoFrom at `from`, and before it, to rhoTo at `to`, and beyond.
void linearGradient(Image& map, MapPoint from, MapPoint to, float rhoFrom, float rhoTo, Ease ease);

/// From rhoInside at the centre to rhoOutside on the circle through `onCircle`, and beyond.
void radialGradient(
    Image& map, MapPoint centre, MapPoint onCircle, float rhoInside, float rhoOutside, Ease ease);

/// gradientMap in steps: strips of rho 0, 1 / (n - 1), ... 1, equally wide for Ease::Linear.
/// strips: below 1 counts as 1, which is all A. degreesClockwise: finite, or counts as 0.
[[nodiscard]] Image
stripMap(Size size, int strips, double degreesClockwise, Ease ease = Ease::Linear);

} // namespace txn
