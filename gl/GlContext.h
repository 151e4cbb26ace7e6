// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"

#include <memory>
#include <string>

namespace txn {

/// What the current OpenGL context can do. The context itself belongs to the caller (a widget, or
/// HeadlessContext), who keeps it current while anything of gl/ is called, and destroys this object
/// with it: everything that was made with it then counts as gone. Move-only.
class GlContext {
  public:
    /// Looks at the context that is current on this thread. Errors: Unsupported for OpenGL below
    /// 3.3.
    [[nodiscard]] static Result<GlContext> current();

    /// Such as "llvmpipe (LLVM 15.0.6, 256 bits)".
    const std::string& renderer() const { return m_renderer; }
    /// Such as "4.5 (Core Profile) Mesa 22.3.6".
    const std::string& version() const { return m_version; }
    /// Whether the processor draws, not a graphics card.
    bool isSoftware() const { return m_software; }
    /// 1 where anisotropic filtering is not to be had.
    float maxAnisotropy() const { return m_maxAnisotropy; }
    int maxTextureSide() const { return m_maxTextureSide; }
    int maxTextureLayers() const { return m_maxTextureLayers; }

    /// Ends with this object.
    std::weak_ptr<const void> life() const { return m_life; }

    GlContext(GlContext&&) = default;
    GlContext& operator=(GlContext&&) = default;

  private:
    GlContext() = default;

    std::string m_renderer;
    std::string m_version;
    bool m_software = false;
    float m_maxAnisotropy = 1.0F;
    int m_maxTextureSide = 0;
    int m_maxTextureLayers = 0;
    std::shared_ptr<const void> m_life = std::make_shared<const int>(0);
};

} // namespace txn
