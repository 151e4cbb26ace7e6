// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/OffscreenTarget.h"

#include "gl/CleanState.h"
#include "gl/FramebufferScope.h"
#include "gl/GlContext.h"
#include "gl/GlErrors.h"
#include "gl/PictureTexture.h"

#include <epoxy/gl.h>

namespace txn {

Result<OffscreenTarget> OffscreenTarget::create(const GlContext& context, Size size) {
    if (size.width < 1 || size.height < 1)
        return Error{ErrorCode::InvalidArgument, "a picture needs at least one pixel"};
    if (size.width > context.maxTextureSide() || size.height > context.maxTextureSide())
        return Error{ErrorCode::TooLarge,
                     "this graphics driver draws at most " +
                         std::to_string(context.maxTextureSide()) + " pixels a side, not " +
                         sizeText(size)};
    forgetGlErrors();
    OffscreenTarget target;
    target.m_size = size;
    target.m_color = pictureTexture(context, GL_RGBA32F, size);
    if (auto ok = checkGlMemory(sizeText(size) + " pixels"); !ok)
        return ok.error();
    target.m_framebuffer = GlHandle::make(context, GlHandle::Kind::Framebuffer);
    const FramebufferScope restore;
    glBindFramebuffer(GL_FRAMEBUFFER, target.m_framebuffer.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER,
                           GL_COLOR_ATTACHMENT0,
                           GL_TEXTURE_2D,
                           target.m_color.id(),
                           0);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        return Error{ErrorCode::Unsupported,
                     "the graphics driver cannot draw pictures of floating point numbers"};
    return target;
}

void OffscreenTarget::bind() const {
    glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer.id());
    glViewport(0, 0, m_size.width, m_size.height);
}

Image OffscreenTarget::read(int channels, Transfer transfer) const {
    assert(channels >= 1 && channels <= 4);
    std::vector<float> pixels(m_size.area() * 4);
    {
        const FramebufferScope restore;
        glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer.id());
        usePlainPixels();
        glReadPixels(0, 0, m_size.width, m_size.height, GL_RGBA, GL_FLOAT, pixels.data());
    }
    Image image(m_size, channels, 0.0F, transfer);
    for (int c = 0; c < channels; ++c) {
        for (int y = 0; y < m_size.height; ++y) {
            const auto row = image.row(c, y);
            const float* from =
                pixels.data() + static_cast<std::size_t>(m_size.height - 1 - y) * row.size() * 4;
            for (std::size_t x = 0; x < row.size(); ++x)
                row[x] = from[4 * x + static_cast<std::size_t>(c)];
        }
    }
    return image;
}

} // namespace txn
