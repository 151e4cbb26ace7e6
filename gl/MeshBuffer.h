// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Geometry.h"
#include "core/base/Result.h"
#include "gl/GlHandle.h"

#include <array>

namespace txn {

/// What the pixels of a picture see of a mesh: textures of points, normals, tangents and steps to
/// the next pixels (mesh_geometry.frag), with a depth buffer. Move-only.
class MeshBuffer {
  public:
    static constexpr int kTextures = 4;

    MeshBuffer() = default;
    /// Errors: TooLarge; Unsupported where the driver cannot draw that.
    [[nodiscard]] static Result<MeshBuffer> create(const GlContext& context, Size size);

    Size size() const { return m_size; }
    explicit operator bool() const { return static_cast<bool>(m_framebuffer); }
    /// Makes it the target of drawing, empty, all of it visible.
    void begin() const;
    /// Binds its textures to units from first on.
    void bindTextures(int first) const;

  private:
    Size m_size;
    GlHandle m_framebuffer;
    GlHandle m_depth;
    std::array<GlHandle, kTextures> m_textures;
};

} // namespace txn
