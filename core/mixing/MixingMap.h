// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/image/Image.h"

#include <string>

namespace txn {

/// What a mixing map says beyond its rectangle: its nearest border, or itself again.
enum class MapBoundary { Clamp, Repeat };

/// Where it lies in the plane, in exemplar pixels.
struct MapPlacement {
    double left = 0.0;
    double top = 0.0;
    double width = 1.0;
    double height = 1.0;

    bool operator==(const MapPlacement&) const = default;
};

/// Which material each place of the plane is of: rho from 0 (all A) to 1 (all B), as a picture
/// spread over a rectangle. A regular value type.
struct MixingMap {
    /// Texels along a side, at most.
    static constexpr int kMaxSide = 8192;

    Image rho{Size{1, 1}, 1}; ///< one channel, 0 to 1
    MapPlacement placement;
    MapBoundary boundary = MapBoundary::Clamp;

    bool operator==(const MixingMap&) const = default;
};

/// Errors: SizeMismatch for other than one channel; TooLarge; Degenerate for values that are not
/// between 0 and 1 (NaN among them); InvalidArgument for an empty rectangle.
[[nodiscard]] Result<void> checkMixingMap(const MixingMap& map);

/// How rho goes from 0 to 1 along a gradient: in proportion, or slowly at both ends
/// (t^2 (3 - 2 t)).
enum class Ease { Linear, Smooth };

/// A gradient from A to B straight across a rectangle of that size, in texels. At 0 degrees it goes
/// from left to right, at 90 from top to bottom; the corners furthest that way and the other have
/// rho 1 and 0.
[[nodiscard]] Image gradientMap(Size size, double degreesClockwise, Ease ease = Ease::Linear);

/// The picture as values of rho: one channel of data, or colours that are all grey. name: for
/// messages. Errors: Unsupported for colours or other numbers of channels; those of checkMixingMap.
[[nodiscard]] Result<Image> mapFromPicture(const Image& picture, const std::string& name);

} // namespace txn
