// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/GlHandle.h"

namespace txn {

/// What fullscreen.vert draws: a triangle over the whole framebuffer. Made when first drawn;
/// move-only.
class FullscreenTriangle {
  public:
    void draw(const GlContext& context);

  private:
    GlHandle m_vertices;
};

} // namespace txn
