// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mixing/TextonField.h"
#include "gl/GlHandle.h"
#include "gl/ShaderLibrary.h"

#include <glm/vec2.hpp>
#include <memory>
#include <vector>

namespace txn {

class ShaderProgram;

/// The cells of impulses, laid over the plane of a mixing map.
struct CellGrid {
    glm::ivec2 base{0};     ///< the cell from which shaders count
    glm::dvec2 cell{1.0};   ///< its sides, in exemplar pixels of the map; negative: against it
    glm::dvec2 middle{0.0}; ///< from where an impulse lies to the middle of its footprint
};

/// A TextonField on the graphics card, as mixing.glsl wants it. Move-only.
class GpuField {
  public:
    /// Uploads the field unless it is there already: nothing but the map, so that painting is
    /// quick. Errors: TooLarge for what the driver cannot hold.
    [[nodiscard]] Result<void> hold(const GlContext& context,
                                    const std::shared_ptr<const TextonField>& field);

    /// What is held.
    const TextonField& field() const { return *m_field; }

    /// Adds what shaders have to be compiled with.
    void addDefines(ShaderDefines& defines) const;
    /// Binds the textures (units 8 and 9) and sets the uniforms of mixing.glsl, save those of the
    /// textons.
    void apply(ShaderProgram& program, const CellGrid& cells) const;
    /// Leaves both texture units empty.
    static void unbind();

  private:
    std::shared_ptr<const TextonField> m_field;
    GlHandle m_map;
    GlHandle m_means;
    std::vector<glm::ivec2> m_meanCorners; ///< of the levels in m_means
};

} // namespace txn
