// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "gl/GlHandle.h"

#include <cstdint>
#include <glm/fwd.hpp>
#include <string>
#include <unordered_map>

namespace txn {

/// A vertex and a fragment shader, linked. Uniforms are set by name while the program is in use;
/// names that the compiler has optimised away are ignored. Empty until built; move-only.
class ShaderProgram {
  public:
    ShaderProgram() = default;

    /// name: for messages. Errors: Unsupported, with the driver's log.
    [[nodiscard]] static Result<ShaderProgram> build(const GlContext& context,
                                                     const std::string& name,
                                                     const std::string& vertexText,
                                                     const std::string& fragmentText);

    explicit operator bool() const { return static_cast<bool>(m_program); }
    void use() const;

    void set(const char* name, float value);
    void set(const char* name, int value);
    void set(const char* name, std::uint32_t value);
    void set(const char* name, const glm::vec2& value);
    void set(const char* name, const glm::ivec2& value);
    void set(const char* name, const glm::vec3& value);
    void set(const char* name, const glm::vec4& value);
    void set(const char* name, const glm::mat2& value);
    void set(const char* name, const glm::mat4& value);

  private:
    int location(const char* name);

    GlHandle m_program;
    std::unordered_map<std::string, int> m_locations;
};

} // namespace txn
