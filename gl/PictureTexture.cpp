// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/PictureTexture.h"

#include <epoxy/gl.h>

namespace txn {

GlHandle pictureTexture(const GlContext& context, unsigned format, Size size) {
    GlHandle texture = GlHandle::make(context, GlHandle::Kind::Texture);
    glBindTexture(GL_TEXTURE_2D, texture.id());
    glTexImage2D(GL_TEXTURE_2D,
                 0,
                 static_cast<GLint>(format),
                 size.width,
                 size.height,
                 0,
                 GL_RGBA,
                 GL_FLOAT,
                 nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    glBindTexture(GL_TEXTURE_2D, 0);
    return texture;
}

} // namespace txn
