// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/MeshBuffer.h"

#include "gl/FramebufferScope.h"
#include "gl/GlErrors.h"
#include "gl/PictureTexture.h"

#include <epoxy/gl.h>

namespace txn {

Result<MeshBuffer> MeshBuffer::create(const GlContext& context, Size size) {
    forgetGlErrors();
    MeshBuffer buffer;
    buffer.m_size = size;
    for (GlHandle& texture : buffer.m_textures)
        texture = pictureTexture(context, GL_RGBA32F, size);
    buffer.m_depth = GlHandle::make(context, GlHandle::Kind::Renderbuffer);
    glBindRenderbuffer(GL_RENDERBUFFER, buffer.m_depth.id());
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, size.width, size.height);
    glBindRenderbuffer(GL_RENDERBUFFER, 0);
    if (auto ok = checkGlMemory(sizeText(size) + " pixels"); !ok)
        return ok.error();
    buffer.m_framebuffer = GlHandle::make(context, GlHandle::Kind::Framebuffer);
    const FramebufferScope restore;
    glBindFramebuffer(GL_FRAMEBUFFER, buffer.m_framebuffer.id());
    std::array<GLenum, kTextures> targets{};
    for (std::size_t i = 0; i < buffer.m_textures.size(); ++i) {
        targets[i] = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i);
        glFramebufferTexture2D(GL_FRAMEBUFFER,
                               targets[i],
                               GL_TEXTURE_2D,
                               buffer.m_textures[i].id(),
                               0);
    }
    glDrawBuffers(kTextures, targets.data());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER,
                              GL_DEPTH_ATTACHMENT,
                              GL_RENDERBUFFER,
                              buffer.m_depth.id());
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        return Error{ErrorCode::Unsupported, "the graphics driver cannot draw meshes"};
    return buffer;
}

void MeshBuffer::begin() const {
    glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer.id());
    glViewport(0, 0, m_size.width, m_size.height);
    constexpr std::array kNothing{0.0F, 0.0F, 0.0F, 0.0F};
    for (int i = 0; i < kTextures; ++i)
        glClearBufferfv(GL_COLOR, i, kNothing.data());
    constexpr float kFar = 1.0F;
    glClearBufferfv(GL_DEPTH, 0, &kFar);
}

void MeshBuffer::bindTextures(int first) const {
    for (std::size_t i = 0; i < m_textures.size(); ++i) {
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(first) + static_cast<GLenum>(i));
        glBindTexture(GL_TEXTURE_2D, m_textures[i].id());
    }
    glActiveTexture(GL_TEXTURE0);
}

} // namespace txn
