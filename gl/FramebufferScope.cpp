// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/FramebufferScope.h"

#include <epoxy/gl.h>

namespace txn {

FramebufferScope::FramebufferScope() {
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &m_draw);
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &m_read);
    glGetIntegerv(GL_VIEWPORT, m_viewport);
}

FramebufferScope::~FramebufferScope() {
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(m_draw));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(m_read));
    glViewport(m_viewport[0], m_viewport[1], m_viewport[2], m_viewport[3]);
}

} // namespace txn
