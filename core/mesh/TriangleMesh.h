// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace txn {

using Triangle = std::array<std::uint32_t, 3>;

/// A surface of triangles that are counter-clockwise seen from outside. A regular value type.
struct TriangleMesh {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals; ///< unit, one per vertex
    std::vector<glm::vec2> uvs;     ///< one per vertex, or empty
    std::vector<Triangle> triangles;

    bool operator==(const TriangleMesh&) const = default;
};

struct BoundingSphere {
    glm::vec3 center{0.0F};
    float radius = 0.0F;

    bool operator==(const BoundingSphere&) const = default;
};

/// A sphere around all vertices, used or not: the centre is that of the bounding box, the radius
/// the distance of the farthest vertex (never less). All zero for a mesh without vertices.
[[nodiscard]] BoundingSphere boundingSphere(const TriangleMesh& mesh);

/// Vertices at exactly the same position (+0 equals -0) as one point.
struct Weld {
    std::vector<std::uint32_t> pointOfVertex; ///< numbered in the order of first appearance
    std::size_t pointCount = 0;
};
[[nodiscard]] Weld weldByPosition(std::span<const glm::vec3> positions);

/// Twice the area and the normal of a triangle: (b - a) x (c - a), in double precision.
[[nodiscard]] glm::dvec3 areaVector(const TriangleMesh& mesh, const Triangle& triangle);

/// Whether the triangle's corners lie on a line as far as single precision tells: twice its area is
/// at most 1e-9 of the square of its longest edge.
[[nodiscard]] bool isDegenerate(const TriangleMesh& mesh, const Triangle& triangle);

/// A unit normal per vertex: the mean of those of the triangles around, weighted by area and by
/// angle. Vertices at the same position share it, even where no triangle joins them, unless the
/// normals of their own triangles are more than creaseDegrees apart and no others at that position
/// lead from one to the other in smaller steps. Degenerate triangles count for nothing; a vertex
/// without any other, or whose triangles cancel exactly, gets +Y. Vertices are not split, and the
/// normals that the mesh has are not read.
[[nodiscard]] std::vector<glm::vec3> smoothNormals(const TriangleMesh& mesh,
                                                   double creaseDegrees = 60.0);

/// Length on the surface of one unit of uv: sqrt(area of the surface / area in uv). Nothing
/// without uvs, or where either area is zero. Overlapping parts of the uv domain count each.
[[nodiscard]] std::optional<double> unitsPerUv(const TriangleMesh& mesh);

} // namespace txn
