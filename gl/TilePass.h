// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/PlanePass.h"

#include <cstddef>

namespace txn {

/// Draws the plane seen from above from lists of the impulses that meet each tile of the picture,
/// made by the processor: the same picture as PlanePass within rounding, and much sooner where the
/// processor draws, since nothing is hashed or tested per pixel. Move-only.
class TilePass {
  public:
    /// Whether lists are worth their while and not too long: not for footprints that are small on
    /// the picture, nor for very many impacts.
    [[nodiscard]] static bool suits(const PlaneView& view, const NoiseSource& source, Size size);

    /// As PlanePass::draw, for what suits.
    [[nodiscard]] Result<void>
    draw(const NoiseSource& source, const PlaneView& view, Size size, glm::dvec2 shift);

  private:
    /// A buffer that shaders read as a texture.
    struct Table {
        GlHandle buffer;
        GlHandle texture;
    };
    static void fill(Table& table,
                     const GlContext& context,
                     unsigned format,
                     const void* data,
                     std::size_t bytes,
                     int unit);

    ShaderVariants m_shaders{"fullscreen.vert", "tiles.frag"};
    FullscreenTriangle m_triangle;
    Table m_impulses;
    Table m_starts;
};

} // namespace txn
