// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/image/Image.h"
#include "gl/GlHandle.h"

namespace txn {

/// Where pictures are drawn before anyone sees them: W x H pixels of four 32-bit floats.
/// Rows go up in OpenGL's way; read() turns them. Move-only.
class OffscreenTarget {
  public:
    OffscreenTarget() = default;

    /// Errors: TooLarge beyond what the driver can draw; Unsupported where it cannot draw floats.
    [[nodiscard]] static Result<OffscreenTarget> create(const GlContext& context, Size size);

    Size size() const { return m_size; }
    explicit operator bool() const { return static_cast<bool>(m_framebuffer); }
    /// For whoever shows the picture.
    unsigned colorTexture() const { return m_color.id(); }

    /// Makes it the target of drawing, all of it visible.
    void bind() const;
    /// The first 1 to 4 channels, exactly as drawn, y down. Waits until all drawing is done.
    [[nodiscard]] Image read(int channels, Transfer transfer) const;

  private:
    Size m_size;
    GlHandle m_framebuffer;
    GlHandle m_color;
};

} // namespace txn
