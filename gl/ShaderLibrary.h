// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace txn {

/// #define lines for a variant of a shader: name and value.
using ShaderDefines = std::vector<std::pair<std::string, std::string>>;

/// Text of a file of resources/shaders, complete: the #version line (GLSL 330), the defines, and
/// each #include "NAME" replaced by that file, once. Errors: NotFound for a name that is not there.
[[nodiscard]] Result<std::string> shaderText(std::string_view name,
                                             const ShaderDefines& defines = {});

} // namespace txn
