// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/ShaderProgram.h"

#include <epoxy/gl.h>
#include <glm/glm.hpp>
#include <glm/gtc/type_ptr.hpp>

namespace txn {
namespace {

std::string cleanLog(std::string log) {
    while (!log.empty() && (log.back() == '\0' || log.back() == '\n'))
        log.pop_back();
    return log;
}

Result<void> attach(unsigned program, GLenum type, const std::string& text) {
    const GLuint shader = glCreateShader(type);
    const char* pointer = text.c_str();
    glShaderSource(shader, 1, &pointer, nullptr);
    glCompileShader(shader);
    GLint ok = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
    std::string log;
    if (ok != GL_TRUE) {
        GLint length = 0;
        glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
        log.resize(static_cast<std::size_t>(length));
        glGetShaderInfoLog(shader, length, nullptr, log.data());
    } else {
        glAttachShader(program, shader);
    }
    glDeleteShader(shader); // lives on while it is attached
    if (ok != GL_TRUE)
        return Error{ErrorCode::Unsupported, cleanLog(log)};
    return {};
}

} // namespace

Result<ShaderProgram> ShaderProgram::build(const GlContext& context,
                                           const std::string& name,
                                           const std::string& vertexText,
                                           const std::string& fragmentText) {
    const auto fail = [&](const std::string& log) {
        return Error{ErrorCode::Unsupported,
                     "the graphics driver refuses the shader '" + name + "': " + log};
    };
    ShaderProgram result;
    result.m_program = GlHandle::make(context, GlHandle::Kind::Program);
    const unsigned id = result.m_program.id();
    if (auto ok = attach(id, GL_VERTEX_SHADER, vertexText); !ok)
        return fail(ok.error().message);
    if (auto ok = attach(id, GL_FRAGMENT_SHADER, fragmentText); !ok)
        return fail(ok.error().message);
    glLinkProgram(id);
    GLint ok = GL_FALSE;
    glGetProgramiv(id, GL_LINK_STATUS, &ok);
    if (ok != GL_TRUE) {
        GLint length = 0;
        glGetProgramiv(id, GL_INFO_LOG_LENGTH, &length);
        std::string log(static_cast<std::size_t>(length), '\0');
        glGetProgramInfoLog(id, length, nullptr, log.data());
        return fail(cleanLog(log));
    }
    return result;
}

void ShaderProgram::use() const {
    glUseProgram(m_program.id());
}

int ShaderProgram::location(const char* name) {
    const auto [it, isNew] = m_locations.try_emplace(name, -1);
    if (isNew)
        it->second = glGetUniformLocation(m_program.id(), name);
    return it->second;
}

void ShaderProgram::set(const char* name, float value) {
    glUniform1f(location(name), value);
}
void ShaderProgram::set(const char* name, int value) {
    glUniform1i(location(name), value);
}
void ShaderProgram::set(const char* name, std::uint32_t value) {
    glUniform1ui(location(name), value);
}
void ShaderProgram::set(const char* name, const glm::vec2& value) {
    glUniform2fv(location(name), 1, glm::value_ptr(value));
}
void ShaderProgram::set(const char* name, const glm::ivec2& value) {
    glUniform2iv(location(name), 1, glm::value_ptr(value));
}
void ShaderProgram::set(const char* name, const glm::vec3& value) {
    glUniform3fv(location(name), 1, glm::value_ptr(value));
}
void ShaderProgram::set(const char* name, const glm::vec4& value) {
    glUniform4fv(location(name), 1, glm::value_ptr(value));
}
void ShaderProgram::set(const char* name, const glm::mat2& value) {
    glUniformMatrix2fv(location(name), 1, GL_FALSE, glm::value_ptr(value));
}
void ShaderProgram::set(const char* name, const glm::mat4& value) {
    glUniformMatrix4fv(location(name), 1, GL_FALSE, glm::value_ptr(value));
}

} // namespace txn
