// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/PlanePass.h"

namespace txn {

/// Draws the plane seen from above by adding up the impulses, one quad each: the same picture as
/// PlanePass within rounding, and much sooner where the processor draws, since nothing is hashed or
/// tested per pixel. Move-only.
class SplatPass {
  public:
    /// Below this size on the picture, impulses are too many and too small to be drawn one by one.
    static constexpr double kSmallestSidePx = 12.0;
    [[nodiscard]] static bool suits(const PlaneView& view, const Texton& texton);

    /// As PlanePass::draw, of the whole framebuffer, which is of 32-bit floats.
    [[nodiscard]] Result<void>
    draw(const NoiseSource& source, const PlaneView& view, Size size, glm::dvec2 shift);

  private:
    ShaderVariants m_shaders{"splat.vert", "splat.frag"};
    GlHandle m_vertices;
    GlHandle m_impulses;
};

} // namespace txn
