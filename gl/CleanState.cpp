// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/CleanState.h"

#include <epoxy/gl.h>
#include <initializer_list>

namespace txn {

void startFromDefaults() {
    for (const GLenum capability : {GL_DEPTH_TEST,
                                    GL_STENCIL_TEST,
                                    GL_SCISSOR_TEST,
                                    GL_CULL_FACE,
                                    GL_BLEND,
                                    GL_COLOR_LOGIC_OP,
                                    GL_RASTERIZER_DISCARD,
                                    GL_PRIMITIVE_RESTART,
                                    GL_SAMPLE_ALPHA_TO_COVERAGE,
                                    GL_SAMPLE_ALPHA_TO_ONE,
                                    GL_SAMPLE_COVERAGE,
                                    GL_SAMPLE_MASK,
                                    GL_FRAMEBUFFER_SRGB})
        glDisable(capability);
    glEnable(GL_MULTISAMPLE);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_TRUE);
    glDepthRange(0.0, 1.0);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    constexpr GLuint kUnits = 7; // those in use
    for (GLuint unit = 0; unit < kUnits; ++unit)
        glBindSampler(unit, 0);
    usePlainPixels();
}

void usePlainPixels() {
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    for (const GLenum name : {GL_PACK_ROW_LENGTH,
                              GL_PACK_SKIP_ROWS,
                              GL_PACK_SKIP_PIXELS,
                              GL_PACK_SWAP_BYTES,
                              GL_UNPACK_ROW_LENGTH,
                              GL_UNPACK_IMAGE_HEIGHT,
                              GL_UNPACK_SKIP_ROWS,
                              GL_UNPACK_SKIP_PIXELS,
                              GL_UNPACK_SKIP_IMAGES,
                              GL_UNPACK_SWAP_BYTES})
        glPixelStorei(name, 0);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
}

} // namespace txn
