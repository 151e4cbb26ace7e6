// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/GlHandle.h"

#include "gl/GlContext.h"

#include <epoxy/gl.h>

namespace txn {

GlHandle GlHandle::make(const GlContext& context, Kind kind) {
    GlHandle handle;
    handle.m_kind = kind;
    handle.m_life = context.life();
    switch (kind) {
    case Kind::Buffer:
        glGenBuffers(1, &handle.m_id);
        break;
    case Kind::VertexArray:
        glGenVertexArrays(1, &handle.m_id);
        break;
    case Kind::Texture:
        glGenTextures(1, &handle.m_id);
        break;
    case Kind::Framebuffer:
        glGenFramebuffers(1, &handle.m_id);
        break;
    case Kind::Renderbuffer:
        glGenRenderbuffers(1, &handle.m_id);
        break;
    case Kind::Program:
        handle.m_id = glCreateProgram();
        break;
    }
    return handle;
}

void GlHandle::reset() noexcept {
    if (m_id != 0 && !m_life.expired()) {
        switch (m_kind) {
        case Kind::Buffer:
            glDeleteBuffers(1, &m_id);
            break;
        case Kind::VertexArray:
            glDeleteVertexArrays(1, &m_id);
            break;
        case Kind::Texture:
            glDeleteTextures(1, &m_id);
            break;
        case Kind::Framebuffer:
            glDeleteFramebuffers(1, &m_id);
            break;
        case Kind::Renderbuffer:
            glDeleteRenderbuffers(1, &m_id);
            break;
        case Kind::Program:
            glDeleteProgram(m_id);
            break;
        }
    }
    m_id = 0;
    m_life.reset();
}

} // namespace txn
