// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/CoverageMask.h"

#include "gl/FramebufferScope.h"
#include "gl/GlErrors.h"
#include "gl/PictureTexture.h"

#include <algorithm>
#include <array>
#include <epoxy/gl.h>

namespace txn {

Result<CoverageMask> CoverageMask::create(const GlContext& context, Size size) {
    GLint most = 0;
    glGetIntegerv(GL_MAX_SAMPLES, &most);
    forgetGlErrors();
    CoverageMask mask;
    mask.m_size = size;
    mask.m_texture = pictureTexture(context, GL_R8, size);
    mask.m_samples = GlHandle::make(context, GlHandle::Kind::Renderbuffer);
    glBindRenderbuffer(GL_RENDERBUFFER, mask.m_samples.id());
    glRenderbufferStorageMultisample(GL_RENDERBUFFER,
                                     std::min(most, 8),
                                     GL_R8,
                                     size.width,
                                     size.height);
    glBindRenderbuffer(GL_RENDERBUFFER, 0);
    if (auto ok = checkGlMemory(sizeText(size) + " pixels"); !ok)
        return ok.error();
    const FramebufferScope restore;
    mask.m_sampleFramebuffer = GlHandle::make(context, GlHandle::Kind::Framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, mask.m_sampleFramebuffer.id());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER,
                              GL_COLOR_ATTACHMENT0,
                              GL_RENDERBUFFER,
                              mask.m_samples.id());
    const bool drawable = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    mask.m_textureFramebuffer = GlHandle::make(context, GlHandle::Kind::Framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, mask.m_textureFramebuffer.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER,
                           GL_COLOR_ATTACHMENT0,
                           GL_TEXTURE_2D,
                           mask.m_texture.id(),
                           0);
    if (!drawable || glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        return Error{ErrorCode::Unsupported, "the graphics driver cannot smooth outlines"};
    return mask;
}

void CoverageMask::begin() const {
    glBindFramebuffer(GL_FRAMEBUFFER, m_sampleFramebuffer.id());
    glViewport(0, 0, m_size.width, m_size.height);
    constexpr std::array kNothing{0.0F, 0.0F, 0.0F, 0.0F};
    glClearBufferfv(GL_COLOR, 0, kNothing.data());
}

void CoverageMask::end() const {
    const int w = m_size.width;
    const int h = m_size.height;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, m_sampleFramebuffer.id());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, m_textureFramebuffer.id());
    glBlitFramebuffer(0, 0, w, h, 0, 0, w, h, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

} // namespace txn
