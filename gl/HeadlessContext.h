// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/GlContext.h"

#include <memory>

namespace txn {

/// An OpenGL 3.3 core context without any window system, through EGL: the first graphics card that
/// has one, the processor (surfaceless Mesa) otherwise. For tests, benchmarks and the command line.
/// It is current on the thread that made it, and to be used and destroyed there. Move-only.
class HeadlessContext {
  public:
    /// Errors: Unsupported where no OpenGL is to be had.
    [[nodiscard]] static Result<HeadlessContext> create();

    HeadlessContext(HeadlessContext&&) noexcept;
    HeadlessContext& operator=(HeadlessContext&&) noexcept;
    ~HeadlessContext();

    const GlContext& gl() const { return *m_gl; }
    /// For a thread that has made several.
    void makeCurrent() const;
    /// Waits until everything asked for has been drawn, so that time can be taken.
    void finish() const;
    /// Whether the driver was reset, where it can tell: nothing is drawn any more, and another
    /// context has to be made. The context must be current.
    bool isLost() const;

  private:
    struct Native;
    HeadlessContext(std::unique_ptr<Native> native, GlContext gl);

    std::unique_ptr<Native> m_native;
    std::unique_ptr<GlContext> m_gl;
};

} // namespace txn
