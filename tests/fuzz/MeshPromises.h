// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/MeshIo.h"
#include "tests/fuzz/FuzzTarget.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace txn::fuzz {

/// What readers of meshes promise of one that they took.
inline bool keepsPromises(const Result<TriangleMesh>& mesh) {
    if (!mesh)
        return false;
    const std::size_t count = mesh->positions.size();
    require(!mesh->triangles.empty(), "there are triangles");
    require(mesh->normals.size() == count, "each vertex has a normal");
    require(mesh->uvs.empty() || mesh->uvs.size() == count, "all vertices have a uv or none has");
    for (const Triangle& triangle : mesh->triangles)
        require(triangle[0] < count && triangle[1] < count && triangle[2] < count,
                "corners are vertices");
    for (std::size_t v = 0; v < count; ++v) {
        const glm::vec3& p = mesh->positions[v];
        require(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z),
                "positions are finite");
        require(std::abs(glm::length(mesh->normals[v]) - 1.0F) <= 1e-4F, "normals have length 1");
    }
    return true;
}

} // namespace txn::fuzz
