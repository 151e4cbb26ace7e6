// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/GlErrors.h"

#include <epoxy/gl.h>

namespace txn {

void forgetGlErrors() {
    for (int i = 0; i < 32 && glGetError() != GL_NO_ERROR; ++i) {
    }
}

} // namespace txn
