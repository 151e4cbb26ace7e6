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
    /// Below this size on the picture, impulses are too many for lists.
    static constexpr double kSmallestFootprintPx = 12.0;
    [[nodiscard]] static bool suits(const PlaneView& view, const Texton& texton);

    /// As PlanePass::draw. Errors: TooLarge where the lists exceed what the driver takes.
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
    GlHandle m_vertices;
    Table m_impulses;
    Table m_starts;
};

} // namespace txn
