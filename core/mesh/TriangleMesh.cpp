// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/TriangleMesh.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include <glm/geometric.hpp>

namespace txn {
namespace {

/// More vertices than this at one point are taken as smooth: comparing all pairs would take long.
constexpr std::size_t kLargestFan = 256;

double angleBetween(const glm::dvec3& a, const glm::dvec3& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// v scaled to length 1, or zero where it is too short to have a direction.
glm::dvec3 unitOrZero(const glm::dvec3& v) {
    const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (!(largest > 0.0) || !std::isfinite(largest))
        return glm::dvec3(0.0);
    return glm::normalize(v / largest);
}

/// Per vertex, the sum over its own triangles of normal x area x angle, with the largest area as
/// the unit so that meshes of any size give the same.
std::vector<glm::dvec3> ownNormals(const TriangleMesh& mesh) {
    double largest = 0.0;
    for (const Triangle& triangle : mesh.triangles)
        largest = std::max(largest, glm::length(areaVector(mesh, triangle)));
    std::vector<glm::dvec3> sums(mesh.positions.size(), glm::dvec3(0.0));
    for (const Triangle& triangle : mesh.triangles) {
        if (isDegenerate(mesh, triangle))
            continue;
        const glm::dvec3 area = areaVector(mesh, triangle) / largest;
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec3 corner(mesh.positions[triangle[k]]);
            const glm::dvec3 next(mesh.positions[triangle[(k + 1) % 3]]);
            const glm::dvec3 last(mesh.positions[triangle[(k + 2) % 3]]);
            sums[triangle[k]] += area * angleBetween(next - corner, last - corner);
        }
    }
    return sums;
}

/// Adds up sums over the members (vertices at one point) that are smoothly joined.
void shareWithinFan(std::span<const std::uint32_t> members,
                    const std::vector<glm::dvec3>& sums,
                    double smallestCosine,
                    std::vector<glm::dvec3>& shared) {
    // Comparing all with all would take forever where very many meet.
    if (members.size() > kLargestFan) {
        glm::dvec3 total(0.0);
        for (const std::uint32_t vertex : members)
            total += sums[vertex];
        for (const std::uint32_t vertex : members)
            shared[vertex] = total;
        return;
    }
    std::vector<glm::dvec3> directions;
    directions.reserve(members.size());
    for (const std::uint32_t vertex : members)
        directions.push_back(unitOrZero(sums[vertex]));
    std::vector<bool> taken(members.size(), false);
    std::vector<std::size_t> cluster;
    for (std::size_t first = 0; first < members.size(); ++first) {
        if (taken[first])
            continue;
        cluster.assign(1, first);
        taken[first] = true;
        glm::dvec3 total(0.0);
        for (std::size_t k = 0; k < cluster.size(); ++k) {
            const std::size_t from = cluster[k];
            total += sums[members[from]];
            for (std::size_t to = first + 1; to < members.size(); ++to) {
                if (!taken[to] && glm::dot(directions[from], directions[to]) >= smallestCosine) {
                    taken[to] = true;
                    cluster.push_back(to);
                }
            }
        }
        for (const std::size_t k : cluster)
            shared[members[k]] = total;
    }
}

} // namespace

BoundingSphere boundingSphere(const TriangleMesh& mesh) {
    if (mesh.positions.empty())
        return {};
    glm::vec3 low = mesh.positions.front();
    glm::vec3 high = low;
    for (const glm::vec3& p : mesh.positions) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    BoundingSphere sphere;
    sphere.center = glm::vec3((glm::dvec3(low) + glm::dvec3(high)) * 0.5);
    double radius = 0.0;
    for (const glm::vec3& p : mesh.positions)
        radius = std::max(radius, glm::distance(glm::dvec3(p), glm::dvec3(sphere.center)));
    sphere.radius = static_cast<float>(radius);
    if (static_cast<double>(sphere.radius) < radius)
        sphere.radius = std::nextafter(sphere.radius, std::numeric_limits<float>::max());
    return sphere;
}

Weld weldByPosition(std::span<const glm::vec3> positions) {
    std::vector<std::uint32_t> order(positions.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        const glm::vec3& p = positions[a];
        const glm::vec3& q = positions[b];
        if (p.x != q.x)
            return p.x < q.x;
        if (p.y != q.y)
            return p.y < q.y;
        return p.z != q.z ? p.z < q.z : a < b;
    });
    std::vector<std::uint32_t> firstAtPosition(positions.size());
    for (std::size_t k = 0; k < order.size(); ++k) {
        const bool same = k > 0 && positions[order[k]] == positions[order[k - 1]];
        firstAtPosition[order[k]] = same ? firstAtPosition[order[k - 1]] : order[k];
    }
    Weld weld;
    weld.pointOfVertex.resize(positions.size());
    for (std::size_t v = 0; v < positions.size(); ++v) {
        weld.pointOfVertex[v] = firstAtPosition[v] == v
                                    ? static_cast<std::uint32_t>(weld.pointCount++)
                                    : weld.pointOfVertex[firstAtPosition[v]];
    }
    return weld;
}

glm::dvec3 areaVector(const TriangleMesh& mesh, const Triangle& triangle) {
    const glm::dvec3 a(mesh.positions[triangle[0]]);
    return glm::cross(glm::dvec3(mesh.positions[triangle[1]]) - a,
                      glm::dvec3(mesh.positions[triangle[2]]) - a);
}

bool isDegenerate(const TriangleMesh& mesh, const Triangle& triangle) {
    double longest = 0.0;
    for (std::size_t k = 0; k < 3; ++k)
        longest = std::max(longest,
                           glm::distance(glm::dvec3(mesh.positions[triangle[k]]),
                                         glm::dvec3(mesh.positions[triangle[(k + 1) % 3]])));
    return !(glm::length(areaVector(mesh, triangle)) > 1e-9 * longest * longest);
}

std::vector<glm::vec3> smoothNormals(const TriangleMesh& mesh, double creaseDegrees) {
    const std::vector<glm::dvec3> sums = ownNormals(mesh);
    const Weld weld = weldByPosition(mesh.positions);

    // The vertices sorted by point: those of point p are from begin[p] to begin[p + 1].
    std::vector<std::uint32_t> begin(weld.pointCount + 1, 0);
    for (const std::uint32_t point : weld.pointOfVertex)
        ++begin[point + 1];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<std::uint32_t> vertices(mesh.positions.size());
    std::vector<std::uint32_t> place(begin.begin(), begin.end() - 1);
    for (std::uint32_t v = 0; v < vertices.size(); ++v)
        vertices[place[weld.pointOfVertex[v]]++] = v;

    const double smallestCosine =
        std::cos(std::clamp(creaseDegrees, 0.0, 180.0) * std::numbers::pi / 180.0) - 1e-9;
    std::vector<glm::dvec3> shared = sums;
    for (std::size_t point = 0; point < weld.pointCount; ++point) {
        const auto count = begin[point + 1] - begin[point];
        if (count > 1)
            shareWithinFan({vertices.data() + begin[point], count}, sums, smallestCosine, shared);
    }

    std::vector<glm::vec3> normals;
    normals.reserve(shared.size());
    for (const glm::dvec3& sum : shared) {
        const glm::dvec3 unit = unitOrZero(sum);
        normals.push_back(unit == glm::dvec3(0.0) ? glm::vec3(0.0F, 1.0F, 0.0F) : glm::vec3(unit));
    }
    return normals;
}

std::optional<double> unitsPerUv(const TriangleMesh& mesh) {
    if (mesh.uvs.empty())
        return std::nullopt;
    assert(mesh.uvs.size() == mesh.positions.size());
    double area = 0.0;
    double uvArea = 0.0;
    for (const Triangle& triangle : mesh.triangles) {
        area += glm::length(areaVector(mesh, triangle));
        const glm::dvec2 a(mesh.uvs[triangle[0]]);
        const glm::dvec2 b = glm::dvec2(mesh.uvs[triangle[1]]) - a;
        const glm::dvec2 c = glm::dvec2(mesh.uvs[triangle[2]]) - a;
        uvArea += std::abs(b.x * c.y - b.y * c.x);
    }
    const double ratio = std::sqrt(area / uvArea);
    if (!(area > 0.0) || !(uvArea > 0.0) || !std::isfinite(ratio))
        return std::nullopt;
    return ratio;
}

} // namespace txn
