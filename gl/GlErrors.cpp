// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/GlErrors.h"

#include <epoxy/gl.h>

namespace txn {

void forgetGlErrors() {
    for (int i = 0; i < 32 && glGetError() != GL_NO_ERROR; ++i) {
    }
}

Result<void> checkGlMemory(const std::string& what) {
    if (glGetError() == GL_NO_ERROR)
        return {};
    return Error{ErrorCode::TooLarge, "there is not enough graphics memory for " + what};
}

} // namespace txn
