// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/texton/Texton.h"
#include "gl/GlHandle.h"
#include "gl/NoiseStyle.h"
#include "gl/ShaderLibrary.h"

#include <glm/vec2.hpp>
#include <span>

namespace txn {

class ShaderProgram;

/// A texton, or those of a mixture, on the graphics card, as the shaders of resources/shaders want
/// them: their kernels, one texton's after the other's, in an array texture, for exact weights
/// (coefficients) or for filtering by the hardware (samples of the kernels with all mipmaps). One
/// channel is shown as grey. Move-only.
class GpuTexton {
  public:
    /// A texel of a mipmap and the interpolation between texels blur more than a pixel of that size
    /// would: with texels of this share of it, noise keeps its energy to a few per cent.
    static constexpr double kMipmapShare = 0.75;

    GpuTexton() = default;

    /// textons: checked by checkMixedTextons, 1 to 4 channels. Errors: InvalidArgument for more;
    /// TooLarge for what the driver cannot hold.
    [[nodiscard]] static Result<GpuTexton>
    create(const GlContext& context, std::span<const Texton> textons, bool filtered);

    /// What shaders have to be compiled with.
    ShaderDefines defines(const GlContext& context, Filter filter) const;
    /// Binds the textures (units 0 and 1, and 10 with the means of several textons) and sets the
    /// uniforms of kernel.glsl and filter.glsl.
    void apply(ShaderProgram& program, const GlContext& context, Filter filter) const;

    /// The same where all pixels of the picture are equally large on the plane, squares of the
    /// given side in exemplar pixels: sooner drawn.
    ShaderDefines definesOneScale(Filter filter, double pixelSide) const;
    /// How far outside its footprint a filtered kernel reaches, in exemplar pixels: to the left and
    /// up, to the right and down.
    struct Reach {
        glm::dvec2 before{0.0};
        glm::dvec2 after{0.0};
    };
    Reach reachOneScale(Filter filter, double pixelSide) const;
    /// right, down: from a pixel to the next ones.
    void applyOneScale(ShaderProgram& program,
                       const GlContext& context,
                       Filter filter,
                       const glm::dvec2& right,
                       const glm::dvec2& down) const;
    /// Leaves the texture units empty.
    static void unbind();

  private:
    ShaderDefines commonDefines() const;
    void setMinFilter(bool mipmaps) const;
    /// How square pixels of one size are filtered.
    struct OneScale {
        int fetches = 1;
        double spread = 0.0; ///< of four fetches from the middle, in pixels' sides
        double level = 0.0;
    };
    OneScale oneScale(Filter filter, double pixelSide) const;

    bool m_filtered = false;
    int m_order = 1;
    int m_density = 1; ///< texels per exemplar pixel
    glm::vec2 m_footprint{0.0F};
    float m_start = 0.0F;     ///< where in the footprint the texture begins
    glm::vec2 m_extent{0.0F}; ///< what it holds, in exemplar pixels
    glm::vec2 m_side{0.0F};   ///< what the texture spans, in exemplar pixels
    GlHandle m_kernels;
    GlHandle m_fades;
    GlHandle m_means; ///< only of several textons
};

} // namespace txn
