// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/noise/ImpulseProcess.h"
#include "core/texton/Texton.h"
#include "gl/FullscreenTriangle.h"
#include "gl/GpuTexton.h"
#include "gl/ShaderVariants.h"
#include "gl/View.h"

#include <glm/vec2.hpp>

namespace txn {

/// What all passes draw from: a texton, on the processor and on the graphics card.
struct NoiseSource {
    const GlContext& context;
    const Texton& texton;
    const GpuTexton& gpu;
    const NoiseStyle& style;

    /// Of the plane.
    ImpulseProcess impulses() const {
        return {style.noise, texton.footprint(), texton.kernelCount()};
    }
};

/// Draws noise of the plane by evaluating it in every pixel: from above, and to the horizon.
/// Move-only.
class PlanePass {
  public:
    /// Fills the bound framebuffer of the given size. shift: of the points at which pixels are
    /// seen, from their centres, in pixels. Leaves its program in use.
    [[nodiscard]] Result<void>
    draw(const NoiseSource& source, const PlaneView& view, Size size, glm::dvec2 shift);
    [[nodiscard]] Result<void>
    draw(const NoiseSource& source, const GroundView& view, Size size, glm::dvec2 shift);

  private:
    ShaderVariants m_above{"fullscreen.vert", "plane.frag"};
    ShaderVariants m_ground{"fullscreen.vert", "perspective.frag"};
    FullscreenTriangle m_triangle;
};

} // namespace txn
