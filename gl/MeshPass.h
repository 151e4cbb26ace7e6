// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/CoverageMask.h"
#include "gl/GpuMesh.h"
#include "gl/MeshBuffer.h"
#include "gl/OffscreenTarget.h"
#include "gl/PlanePass.h"

#include <glm/mat4x4.hpp>

namespace txn {

/// What MeshPass has to know of a mesh besides its triangles.
struct MeshShape {
    BoundingSphere bounds;
    double unitsPerUv = 1.0; ///< length on the mesh of one unit of texture coordinates
};

/// Draws a mesh covered with noise, in two steps: what the pixels see, then noise on that. Noise is
/// thereby computed once a pixel, whatever the size of the triangles. Move-only.
class MeshPass {
  public:
    /// As PlanePass::draw, onto target. smooth: outlines are smoothed where the driver can.
    [[nodiscard]] Result<void> draw(const NoiseSource& source,
                                    const MeshView& view,
                                    const GpuMesh& mesh,
                                    const MeshShape& shape,
                                    const OffscreenTarget& target,
                                    glm::dvec2 shift,
                                    bool smooth);

  private:
    /// Draws what the pixels see into m_buffer, which has the picture's size.
    Result<void> look(const GlContext& context,
                      const GpuMesh& mesh,
                      bool surface,
                      const glm::mat4& toPicture,
                      float pixelsPerUnit);
    /// Fills m_mask; false where the driver cannot.
    bool cover(const GlContext& context, const GpuMesh& mesh, const glm::mat4& toPicture);

    ShaderVariants m_geometry{"mesh.vert", "mesh_geometry.frag"};
    ShaderVariants m_cover{"mesh.vert", "mesh_cover.frag"};
    ShaderVariants m_noise{"fullscreen.vert", "mesh_noise.frag"};
    FullscreenTriangle m_triangle;
    MeshBuffer m_buffer;
    CoverageMask m_mask;
    Size m_refusedMask; ///< a size for which there is none
};

} // namespace txn
