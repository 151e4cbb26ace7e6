// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/TriangleMesh.h"

#include <vector>

#include <glm/vec3.hpp>

namespace txn {

/// A unit tangent per vertex, orthogonal to the vertex's normal, that turns as little as possible
/// over the surface: smooth save at isolated points, which any field on a sphere must have.
/// Vertices at the same position are one point, so that seams of uvs and patches that are not
/// joined do not show. At creases, every vertex has the projection of the point's direction onto
/// its own plane. The field of each connected part is turned as a whole to run along +x as far as
/// it can. Any mesh will do: open, in parts, with edges of more than two triangles, of any scale,
/// with vertices that no triangle uses. Same input, same output. Time grows as n^1.5, memory as n
/// log n (sparse factorization). Normals must be finite and of length 1. [KCPS13] Knoeppel, Crane,
/// Pinkall, Schroeder, Globally Optimal Direction Fields, n = 1, s = 0.
[[nodiscard]] std::vector<glm::vec3> tangentField(const TriangleMesh& mesh);

} // namespace txn
