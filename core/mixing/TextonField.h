// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Geometry.h"
#include "core/mixing/MixingMap.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace txn {

/// Which of R textons along the way from A to B each place of the plane takes: a mixing map made
/// ready for evaluation. Places between two textons take either of them by chance, in proportion,
/// so that no border between strips can be seen. Integers decide, so that the GPU decides alike.
/// Immutable; thread-safe.
class TextonField {
  public:
    /// Positions along the textons are whole multiples of 1 / kSteps.
    static constexpr int kSteps = 1024;
    static constexpr int kMaxTextons = 64;

    /// Texton 0 everywhere.
    TextonField() : TextonField({}, 1, {1, 1}) {}
    /// map: checked by checkMixingMap. textons: R, 1 to kMaxTextons. footprint: that of the
    /// textons, by whose width the mean is smoothed.
    TextonField(const MixingMap& map, int textons, Size footprint);

    /// R.
    int textonCount() const { return m_textonCount; }

    /// Whether one texton is taken everywhere, and the mean is that texton's.
    bool isConstant() const { return m_constant; }

    /// 0 to R - 1, for an impulse whose footprint is centred on (x, y). choice: 10 random bits.
    int textonAt(double x, double y, std::uint32_t choice) const {
        const std::uint32_t position =
            m_positions[static_cast<std::size_t>(
                            texelAt(y, m_placement.top, m_placement.height, m_size.height)) *
                            static_cast<std::size_t>(m_size.width) +
                        static_cast<std::size_t>(
                            texelAt(x, m_placement.left, m_placement.width, m_size.width))];
        const std::uint32_t rest = position % kSteps;
        return static_cast<int>(position / kSteps + (choice < rest ? 1 : 0));
    }

    /// Where the mean colour lies along the textons', 0 to R - 1, at every (xs[i], ys[j]), row
    /// after row: the map smoothed by a cubic B-spline as wide as the footprint (over means of the
    /// map in cells of a quarter of it). Exact where the map is constant all around.
    void meanPositions(std::span<const double> xs,
                       std::span<const double> ys,
                       std::span<float> out) const;

    /// What the GPU needs, too: kSteps times the position along the textons, row after row.
    std::span<const std::uint16_t> positions() const { return m_positions; }
    Size size() const { return m_size; } ///< in texels
    MapPlacement placement() const { return m_placement; }
    MapBoundary boundary() const { return m_boundary; }
    /// Coefficients of the B-spline, one for each cell of the map's rectangle, row after row.
    std::span<const float> meanCoefficients() const { return m_coefficients; }
    Size cells() const { return m_cells; }

  private:
    int texelAt(double at, double start, double length, int count) const {
        return wrapped(std::floor((at - start) / length * count), count);
    }
    int wrapped(double index, int count) const {
        if (m_boundary == MapBoundary::Repeat)
            index -= std::floor(index / count) * count;
        return static_cast<int>(std::clamp(index, 0.0, count - 1.0));
    }
    struct Taps;
    [[nodiscard]] Taps taps(double at, double start, double length, int count) const;

    int m_textonCount;
    Size m_size;
    Size m_cells;
    MapPlacement m_placement;
    MapBoundary m_boundary;
    bool m_constant;
    std::vector<std::uint16_t> m_positions;
    std::vector<float> m_coefficients;
};

/// Means of a grid of values, row after row, over the cells of another grid on the same rectangle.
/// Exact where all values are equal.
[[nodiscard]] std::vector<float> gridMeans(std::span<const float> values, Size from, Size to);

} // namespace txn
