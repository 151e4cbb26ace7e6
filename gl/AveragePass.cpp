// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/AveragePass.h"

#include <array>
#include <epoxy/gl.h>

namespace txn {

void AveragePass::begin() {
    constexpr std::array kNothing{0.0F, 0.0F, 0.0F, 0.0F};
    glClearBufferfv(GL_COLOR, 0, kNothing.data());
}

Result<void>
AveragePass::add(const GlContext& context, const OffscreenTarget& picture, float share) {
    auto program = m_shaders.get(context, {});
    if (!program)
        return program.error();
    (*program)->use();
    (*program)->set("picture", 0);
    (*program)->set("share", share);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, picture.colorTexture());
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFunc(GL_ONE, GL_ONE);
    m_triangle.draw(context);
    glDisable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ZERO);
    glBindTexture(GL_TEXTURE_2D, 0);
    return {};
}

} // namespace txn
