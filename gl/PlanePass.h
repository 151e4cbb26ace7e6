// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/noise/ImpulseProcess.h"
#include "core/texton/Texton.h"
#include "gl/FullscreenTriangle.h"
#include "gl/GpuTexton.h"
#include "gl/ShaderVariants.h"
#include "gl/View.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace txn {

/// What all passes draw from: a texton, on the processor and on the graphics card.
struct NoiseSource {
    const GlContext& context;
    const Texton& texton;
    const GpuTexton& gpu;
    const NoiseStyle& style;
    /// Where a material is shaded: a picture of its relief (see MaterialTextons), of the same size,
    /// drawn before; 0 otherwise.
    unsigned reliefTexture = 0;

    /// Of the plane.
    ImpulseProcess impulses() const {
        return {style.noise, texton.footprint(), texton.kernelCount()};
    }
};

/// Adds what shaders have to be compiled with for the source's material, or for none.
void addMaterialDefines(ShaderDefines& defines, const NoiseSource& source);
/// Binds the relief, if there is one, and tells the shader where the light is, in its coordinates.
void applyMaterial(ShaderProgram& shader, const NoiseSource& source, const glm::dvec3& toLight);
/// Leaves its texture unit empty.
void unbindMaterial();
/// The same for planes seen from above.
void applyPlaneMaterial(ShaderProgram& shader,
                        const NoiseSource& source,
                        glm::dvec2 right,
                        glm::dvec2 down);

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
