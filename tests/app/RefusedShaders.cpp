// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/RefusedShaders.h"

#include <atomic>
#include <cassert>
#include <epoxy/egl.h>
#include <epoxy/gl.h>

namespace txn::test {
namespace {

PFNGLSHADERSOURCEPROC s_before = nullptr;
std::string s_word;
std::atomic<int> s_count{0};

void spoil(GLuint shader, GLsizei count, const GLchar* const* texts, const GLint* lengths) {
    assert(count == 1 && lengths == nullptr); // as the program calls it
    static_cast<void>(count);
    static_cast<void>(lengths);
    std::string text = texts[0];
    if (text.find(s_word) != std::string::npos) {
        text += "\n#error injected\n";
        ++s_count;
    }
    // libepoxy's own pointer may still be one that looks for the function where this one is now.
    static const auto original =
        reinterpret_cast<PFNGLSHADERSOURCEPROC>(eglGetProcAddress("glShaderSource"));
    const GLchar* pointer = text.c_str();
    original(shader, 1, &pointer, nullptr);
}

} // namespace

RefusedShaders::RefusedShaders(std::string word) {
    s_word = std::move(word);
    s_count = 0;
    s_before = epoxy_glShaderSource;
    epoxy_glShaderSource = &spoil;
}

RefusedShaders::~RefusedShaders() {
    epoxy_glShaderSource = s_before;
}

int RefusedShaders::count() const {
    return s_count;
}

} // namespace txn::test
