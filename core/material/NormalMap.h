// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/image/Image.h"

namespace txn {

/// Steeper slopes than this are taken for it: normals that lie in the plane, or below it, have no
/// slope.
inline constexpr float kSteepestSlope = 16.0F;

/// A map of unit normals in tangent space (3 channels, stored as 0.5 + 0.5 n; z towards the eye, y
/// up unless yDown) as slopes: d height / dx and d height / dy, y down; 2 channels, Encoded.
/// Lengths other than 1 do not matter. Slopes add up as normals do not, so textures may be mixed
/// in them.
[[nodiscard]] Image slopesOfNormals(const Image& normals, bool yDown);

/// The reverse, with unit normals: 2 channels to 3.
[[nodiscard]] Image normalsOfSlopes(const Image& slopes, bool yDown);

} // namespace txn
