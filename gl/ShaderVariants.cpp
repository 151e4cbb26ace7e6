// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/ShaderVariants.h"

namespace txn {

Result<ShaderProgram*> ShaderVariants::get(const GlContext& context, const ShaderDefines& defines) {
    std::string key;
    for (const auto& [name, value] : defines)
        key.append(name).append("=").append(value).append(";");
    if (const auto known = m_programs.find(key); known != m_programs.end())
        return &known->second;
    const auto vertex = shaderText(m_vertexFile, defines);
    if (!vertex)
        return vertex.error();
    const auto fragment = shaderText(m_fragmentFile, defines);
    if (!fragment)
        return fragment.error();
    auto program = ShaderProgram::build(context, m_fragmentFile, *vertex, *fragment);
    if (!program)
        return program.error();
    return &m_programs.emplace(key, std::move(*program)).first->second;
}

} // namespace txn
