// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace txn {

/// Puts back the framebuffer and the viewport of the caller, whose window may be one of them.
class FramebufferScope {
  public:
    FramebufferScope();
    ~FramebufferScope();
    FramebufferScope(const FramebufferScope&) = delete;
    FramebufferScope& operator=(const FramebufferScope&) = delete;

  private:
    int m_draw = 0;
    int m_read = 0;
    int m_viewport[4] = {};
};

} // namespace txn
