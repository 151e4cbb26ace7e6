// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/texton/Texton.h"
#include "gl/GlHandle.h"
#include "gl/NoiseStyle.h"
#include "gl/ShaderLibrary.h"

#include <glm/vec2.hpp>

namespace txn {

class ShaderProgram;

/// A texton on the graphics card, as the shaders of resources/shaders want it: its kernels in an
/// array texture, for exact weights (coefficients) or for filtering by the hardware (samples of the
/// kernels with all mipmaps). One channel is shown as grey. Move-only.
class GpuTexton {
  public:
    GpuTexton() = default;

    /// texton: 1 to 4 channels. Errors: Unsupported for more; TooLarge for what the driver cannot
    /// hold.
    [[nodiscard]] static Result<GpuTexton>
    create(const GlContext& context, const Texton& texton, bool filtered);

    /// What the shaders have to be compiled with. oneScale: all pixels of the picture are equally
    /// large on the plane, which is sooner drawn.
    ShaderDefines defines(const GlContext& context, Filter filter, bool oneScale) const;
    /// Binds the textures (units 0 and 1) and sets the uniforms of kernel.glsl and filter.glsl.
    void apply(ShaderProgram& program, const GlContext& context, Filter filter) const;
    /// The same for shaders of one scale. right, down: from a pixel to the next ones, in exemplar
    /// pixels, equally long and at right angles.
    void applyOneScale(ShaderProgram& program,
                       const GlContext& context,
                       Filter filter,
                       const glm::dvec2& right,
                       const glm::dvec2& down) const;
    /// Leaves both texture units empty.
    static void unbind();

  private:
    bool m_filtered = false;
    int m_order = 1;
    int m_density = 1; ///< texels per exemplar pixel
    glm::vec2 m_footprint{0.0F};
    glm::vec2 m_side{0.0F}; ///< what the texture spans, in exemplar pixels
    GlHandle m_kernels;
    GlHandle m_fades;
};

} // namespace txn
