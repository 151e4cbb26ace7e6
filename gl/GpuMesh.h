// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/mesh/TriangleMesh.h"
#include "gl/GlHandle.h"

namespace txn {

/// A mesh on the graphics card, with a tangent per vertex: attributes 0 to 3 are position, normal,
/// texture coordinate (zero if it has none) and tangent. Move-only.
class GpuMesh {
  public:
    GpuMesh() = default;
    /// tangents: one per vertex. center: what becomes the origin, so that meshes far from it lose
    /// nothing. Errors: TooLarge.
    [[nodiscard]] static Result<GpuMesh> create(const GlContext& context,
                                                const TriangleMesh& mesh,
                                                const std::vector<glm::vec3>& tangents,
                                                const glm::vec3& center);

    explicit operator bool() const { return static_cast<bool>(m_vertexArray); }
    void draw() const;

  private:
    GlHandle m_vertexArray;
    GlHandle m_vertices;
    GlHandle m_indices;
    int m_indexCount = 0;
};

} // namespace txn
