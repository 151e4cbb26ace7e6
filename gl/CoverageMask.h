// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Geometry.h"
#include "core/base/Result.h"
#include "gl/GlHandle.h"

namespace txn {

/// How much of each pixel something covers, by several samples a pixel: makes outlines smooth. Draw
/// white between begin() and end(). Move-only.
class CoverageMask {
  public:
    CoverageMask() = default;
    /// Errors: TooLarge; Unsupported where the driver has no multisampling.
    [[nodiscard]] static Result<CoverageMask> create(const GlContext& context, Size size);

    Size size() const { return m_size; }
    /// Makes it the target of drawing, empty, all of it visible.
    void begin() const;
    /// Averages the samples into the texture.
    void end() const;
    unsigned texture() const { return m_texture.id(); }

  private:
    Size m_size;
    GlHandle m_samples;
    GlHandle m_sampleFramebuffer;
    GlHandle m_texture;
    GlHandle m_textureFramebuffer;
};

} // namespace txn
