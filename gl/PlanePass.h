// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/noise/ImpulseProcess.h"
#include "core/texton/Texton.h"
#include "gl/FullscreenTriangle.h"
#include "gl/GpuField.h"
#include "gl/GpuTexton.h"
#include "gl/ShaderVariants.h"
#include "gl/View.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>

namespace txn {

struct PlaneMap;

/// What all passes draw from: a texton or a mixture, on the processor and on the graphics card.
struct NoiseSource {
    const GlContext& context;
    std::span<const Texton> textons;
    const GpuTexton& gpu;
    const GpuField* field; ///< which of several textons each place takes; null: there is one
    const NoiseStyle& style;
    /// Where a material is shaded: a picture of its relief (see MaterialTextons), of the same size,
    /// drawn before; 0 otherwise.
    unsigned reliefTexture = 0;

    /// What all textons have in common can be read from the first one.
    const Texton& first() const { return textons.front(); }
    glm::dvec2 footprint() const { return {first().footprint().width, first().footprint().height}; }
    /// Of the plane.
    ImpulseProcess impulses() const {
        return {style.noise, first().footprint(), first().kernelCount()};
    }
};

/// Tells mixing.glsl where the map lies, if there is one; base: the cell that positions are counted
/// from.
void applyPlaneField(ShaderProgram& shader,
                     const NoiseSource& source,
                     const ImpulseProcess& impulses,
                     glm::ivec2 base);
/// Sets the uniforms of plane_place.glsl for pixels seen shift away from their centres, and of
/// mixing.glsl.
void applyPlanePlace(ShaderProgram& shader,
                     const NoiseSource& source,
                     const PlaneMap& map,
                     Size size,
                     glm::dvec2 shift);

/// Adds what shaders have to be compiled with for the source's map and material, or for none.
void addSourceDefines(ShaderDefines& defines, const NoiseSource& source);
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
