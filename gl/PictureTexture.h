// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Geometry.h"
#include "gl/GlHandle.h"

namespace txn {

/// A texture with one texel per pixel of a picture, of the given OpenGL format, to draw to and to
/// fetch from. Leaves no texture bound. Errors are OpenGL's.
[[nodiscard]] GlHandle pictureTexture(const GlContext& context, unsigned format, Size size);

} // namespace txn
