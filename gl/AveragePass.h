// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/FullscreenTriangle.h"
#include "gl/OffscreenTarget.h"
#include "gl/ShaderVariants.h"

namespace txn {

/// Averages pictures: adds a share of one to the bound framebuffer. Move-only.
class AveragePass {
  public:
    /// Empties the bound framebuffer.
    static void begin();
    /// picture: of the framebuffer's size.
    [[nodiscard]] Result<void>
    add(const GlContext& context, const OffscreenTarget& picture, float share);

  private:
    ShaderVariants m_shaders{"fullscreen.vert", "average.frag"};
    FullscreenTriangle m_triangle;
};

} // namespace txn
