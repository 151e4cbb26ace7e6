// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/noise/NoiseParams.h"
#include "gl/Light.h"

namespace txn {

/// How a picture of noise is kept from flickering where it is seen from afar, by filtering its
/// kernels ([TN17] section 5). None: not at all; a pixel is a point of the noise, in full
/// precision. Mipmap: the hardware's mipmaps, by the longer side of a pixel on the plane: blurred
/// towards the horizon. Anisotropic: several fetches from mipmaps, 4 over the square pixels of a
/// plane view, elsewhere up to 16 along the longer axis of what a pixel covers. Hardware: the
/// driver's own anisotropic filter, as in the paper; mipmaps where it has none.
enum class Filter { None, Mipmap, Anisotropic, Hardware };

/// How the plane seen from above is drawn; the picture is the same. PerPixel: every pixel looks for
/// the impulses around it. Tiles: the processor lists the impulses of each small tile first.
/// Automatic: tiles where the processor draws anyway and footprints are not too small.
enum class PlaneMethod { Automatic, PerPixel, Tiles };

/// Which noise is drawn and how. A regular value.
struct NoiseStyle {
    static constexpr int kMaxSupersampling = 64;

    NoiseParams noise;
    Filter filter = Filter::Anisotropic;
    /// N: a pixel is the average of N x N points, drawn one after the other.
    int supersampling = 1;
    PlaneMethod planeMethod = PlaneMethod::Automatic;
    Light light; ///< of shaded materials

    bool operator==(const NoiseStyle&) const = default;
};

} // namespace txn
