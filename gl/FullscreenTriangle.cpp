// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/FullscreenTriangle.h"

#include <epoxy/gl.h>

namespace txn {

void FullscreenTriangle::draw(const GlContext& context) {
    if (!m_vertices)
        m_vertices = GlHandle::make(context, GlHandle::Kind::VertexArray);
    glBindVertexArray(m_vertices.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
}

} // namespace txn
