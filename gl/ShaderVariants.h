// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/ShaderLibrary.h"
#include "gl/ShaderProgram.h"

#include <unordered_map>

namespace txn {

/// One pair of shader files, compiled for each set of defines when that is first asked for.
/// Move-only.
class ShaderVariants {
  public:
    ShaderVariants(std::string vertexFile, std::string fragmentFile)
        : m_vertexFile(std::move(vertexFile)), m_fragmentFile(std::move(fragmentFile)) {}

    /// Valid until this object is moved or gone. Errors: those of shaderText and ShaderProgram.
    [[nodiscard]] Result<ShaderProgram*> get(const GlContext& context,
                                             const ShaderDefines& defines);

  private:
    std::string m_vertexFile;
    std::string m_fragmentFile;
    std::unordered_map<std::string, ShaderProgram> m_programs; ///< by their defines
};

} // namespace txn
