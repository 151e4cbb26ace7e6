// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/GlContext.h"

#include <algorithm>
#include <array>
#include <epoxy/gl.h>

namespace txn {
namespace {

std::string text(GLenum name) {
    const GLubyte* value = glGetString(name);
    return value != nullptr ? reinterpret_cast<const char*>(value) : "";
}

int integer(GLenum name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

} // namespace

Result<GlContext> GlContext::current() {
    GlContext context;
    context.m_version = text(GL_VERSION);
    context.m_renderer = text(GL_RENDERER);
    if (!epoxy_is_desktop_gl() || epoxy_gl_version() < 33)
        return Error{ErrorCode::Unsupported,
                     "OpenGL 3.3 is needed, this is '" + context.m_version +
                         "'; please update the graphics driver"};
    constexpr std::array kSoftware{"llvmpipe", "softpipe", "swrast", "SWR", "Software"};
    context.m_software = std::any_of(kSoftware.begin(), kSoftware.end(), [&](const char* name) {
        return context.m_renderer.find(name) != std::string::npos;
    });
    if (epoxy_has_gl_extension("GL_EXT_texture_filter_anisotropic") ||
        epoxy_has_gl_extension("GL_ARB_texture_filter_anisotropic"))
        glGetFloatv(GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT, &context.m_maxAnisotropy);
    context.m_maxTextureSide = integer(GL_MAX_TEXTURE_SIZE);
    context.m_maxTextureLayers = integer(GL_MAX_ARRAY_TEXTURE_LAYERS);
    return context;
}

} // namespace txn
