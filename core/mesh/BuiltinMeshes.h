// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/TriangleMesh.h"

#include <optional>
#include <string_view>

namespace txn {

// Made here rather than read: with normals that are exact, uvs in [0, 1], y up, triangles
// counter-clockwise seen from outside. Vertices are repeated along the seams of the uvs.

/// The square [-1, 1]^2 in x and z, seen from +y, of cells x cells squares; u runs along +x, v
/// along -z.
[[nodiscard]] TriangleMesh planeMesh(int cells = 32);

/// Radius 1: 128 x 64 patches of longitude and latitude. u runs to the east (right-handed about
/// +y), v to the north pole. A pole is a vertex per triangle there (and one that is not used), its
/// u in the middle of it.
[[nodiscard]] TriangleMesh sphereMesh();

/// Around the y axis, radii 1 and 0.4: 128 x 64 patches. u runs around the axis, v around the tube
/// from the outer equator upwards.
[[nodiscard]] TriangleMesh torusMesh();

/// "plane", "sphere" or "torus"; nothing for other names.
[[nodiscard]] std::optional<TriangleMesh> builtinMesh(std::string_view name);

} // namespace txn
