// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/BuiltinMeshes.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace txn {
namespace {

constexpr int kMeridians = 128;
constexpr int kParallels = 64;
constexpr double kMinorRadius = 0.4;

/// Vertex (column, row) of a grid of columns + 1 by rows + 1 has index row * (columns + 1) +
/// column.
std::uint32_t gridIndex(int column, int row, int columns) {
    return static_cast<std::uint32_t>(row * (columns + 1) + column);
}

/// Both triangles of every cell; columns to the right and rows upwards as seen from outside.
std::vector<Triangle> gridTriangles(int columns, int rows) {
    std::vector<Triangle> triangles;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const std::uint32_t a = gridIndex(column, row, columns);
            const std::uint32_t b = gridIndex(column + 1, row, columns);
            const std::uint32_t c = gridIndex(column + 1, row + 1, columns);
            const std::uint32_t d = gridIndex(column, row + 1, columns);
            triangles.push_back({a, b, c});
            triangles.push_back({a, c, d});
        }
    }
    return triangles;
}

glm::vec2 gridUv(double column, int row, int columns, int rows) {
    return {static_cast<float>(column / columns),
            static_cast<float>(static_cast<double>(row) / rows)};
}

/// Cosine and sine of step / steps of a turn; the sine is exactly zero where it should be, so that
/// seams close.
struct Turn {
    Turn(int step, int steps) {
        const double angle = 2.0 * std::numbers::pi * step / steps;
        cosine = std::cos(angle);
        sine = 2 * step % steps == 0 ? 0.0 : std::sin(angle);
    }
    double cosine;
    double sine;
};

glm::vec3 toFloat(double x, double y, double z) {
    return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
}

} // namespace

TriangleMesh planeMesh(int cells) {
    assert(cells > 0);
    TriangleMesh mesh;
    for (int row = 0; row <= cells; ++row) {
        for (int column = 0; column <= cells; ++column) {
            mesh.positions.push_back(
                toFloat(2.0 * column / cells - 1.0, 0.0, 1.0 - 2.0 * row / cells));
            mesh.normals.emplace_back(0.0F, 1.0F, 0.0F);
            mesh.uvs.push_back(gridUv(column, row, cells, cells));
        }
    }
    mesh.triangles = gridTriangles(cells, cells);
    return mesh;
}

TriangleMesh sphereMesh() {
    TriangleMesh mesh;
    for (int row = 0; row <= kParallels; ++row) {
        const bool pole = row == 0 || row == kParallels;
        const Turn latitude(row, 2 * kParallels); // from the south pole: half a turn in all
        for (int column = 0; column <= kMeridians; ++column) {
            const Turn longitude(column, kMeridians);
            const double width = pole ? 0.0 : latitude.sine;
            const glm::vec3 p =
                toFloat(width * longitude.cosine, -latitude.cosine, 0.0 - width * longitude.sine);
            mesh.positions.push_back(p);
            mesh.normals.push_back(p);
            // The one triangle that uses a pole's vertex lies to the east in the south, where cells
            // keep their upper left half, and to the west in the north.
            const double shift = pole ? (row == 0 ? 0.5 : -0.5) : 0.0;
            const double u = std::clamp(column + shift, 0.0, double{kMeridians});
            mesh.uvs.push_back(gridUv(u, row, kMeridians, kParallels));
        }
    }
    mesh.triangles = gridTriangles(kMeridians, kParallels);
    std::erase_if(mesh.triangles, [&](const Triangle& t) { return isDegenerate(mesh, t); });
    return mesh;
}

TriangleMesh torusMesh() {
    TriangleMesh mesh;
    for (int row = 0; row <= kParallels; ++row) {
        const Turn tube(row, kParallels);
        for (int column = 0; column <= kMeridians; ++column) {
            const Turn around(column, kMeridians);
            const double distance = 1.0 + kMinorRadius * tube.cosine;
            mesh.positions.push_back(toFloat(distance * around.cosine,
                                             kMinorRadius * tube.sine,
                                             0.0 - distance * around.sine));
            mesh.normals.push_back(
                toFloat(tube.cosine * around.cosine, tube.sine, 0.0 - tube.cosine * around.sine));
            mesh.uvs.push_back(gridUv(column, row, kMeridians, kParallels));
        }
    }
    mesh.triangles = gridTriangles(kMeridians, kParallels);
    return mesh;
}

std::optional<TriangleMesh> builtinMesh(std::string_view name) {
    if (name == "plane")
        return planeMesh();
    if (name == "sphere")
        return sphereMesh();
    if (name == "torus")
        return torusMesh();
    return std::nullopt;
}

} // namespace txn
