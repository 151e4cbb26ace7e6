// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/HeadlessContext.h"

#include <array>
#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <string_view>
#include <vector>

namespace txn {

/// The display is shared with every other context on it and stays initialised.
struct HeadlessContext::Native {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;

    Native() = default;
    Native(const Native&) = delete;
    Native& operator=(const Native&) = delete;
    ~Native() {
        if (context == EGL_NO_CONTEXT)
            return;
        if (eglGetCurrentContext() == context)
            eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display, context);
    }
    bool makeCurrent() const {
        return eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_TRUE;
    }
};

namespace {

bool listed(const char* extensions, std::string_view name) {
    return extensions != nullptr &&
           std::string_view(extensions).find(name) != std::string_view::npos;
}

/// Graphics cards first, then Mesa without a card, then whatever the system thinks best.
std::vector<EGLDisplay> displays() {
    std::vector<EGLDisplay> found;
    const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    if (listed(extensions, "EGL_EXT_platform_device") &&
        (listed(extensions, "EGL_EXT_device_enumeration") ||
         listed(extensions, "EGL_EXT_device_base"))) {
        std::array<EGLDeviceEXT, 16> devices{};
        EGLint count = 0;
        if (eglQueryDevicesEXT(static_cast<EGLint>(devices.size()), devices.data(), &count)) {
            for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
                if (!listed(eglQueryDeviceStringEXT(devices[i], EGL_EXTENSIONS),
                            "EGL_MESA_device_software"))
                    found.push_back(
                        eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr));
            }
        }
    }
    if (listed(extensions, "EGL_MESA_platform_surfaceless"))
        found.push_back(
            eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
    found.push_back(eglGetDisplay(EGL_DEFAULT_DISPLAY));
    return found;
}

/// An OpenGL 3.3 core context on the display, or none.
EGLContext openGl(EGLDisplay display) {
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr) ||
        !eglBindAPI(EGL_OPENGL_API))
        return EGL_NO_CONTEXT;
    const char* extensions = eglQueryString(display, EGL_EXTENSIONS);
    if (!listed(extensions, "EGL_KHR_surfaceless_context"))
        return EGL_NO_CONTEXT;
    EGLConfig config = EGL_NO_CONFIG_KHR;
    if (!listed(extensions, "EGL_KHR_no_config_context") &&
        !listed(extensions, "EGL_MESA_configless_context")) {
        constexpr std::array<EGLint, 5> kAny{EGL_RENDERABLE_TYPE,
                                             EGL_OPENGL_BIT,
                                             EGL_SURFACE_TYPE,
                                             0,
                                             EGL_NONE};
        EGLint count = 0;
        if (!eglChooseConfig(display, kAny.data(), &config, 1, &count) || count == 0)
            return EGL_NO_CONTEXT;
    }
    // With notification a driver that was reset says so; without, isLost() never does.
    constexpr std::array<EGLint, 9> kCore{EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY,
                                          EGL_LOSE_CONTEXT_ON_RESET,
                                          EGL_CONTEXT_MAJOR_VERSION,
                                          3,
                                          EGL_CONTEXT_MINOR_VERSION,
                                          3,
                                          EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                          EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                          EGL_NONE};
    const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, kCore.data());
    return context != EGL_NO_CONTEXT
               ? context
               : eglCreateContext(display, config, EGL_NO_CONTEXT, kCore.data() + 2);
}

} // namespace

HeadlessContext::HeadlessContext(std::unique_ptr<Native> native, GlContext gl)
    : m_native(std::move(native)), m_gl(std::make_unique<GlContext>(std::move(gl))) {}
HeadlessContext::HeadlessContext(HeadlessContext&&) noexcept = default;
HeadlessContext& HeadlessContext::operator=(HeadlessContext&&) noexcept = default;
HeadlessContext::~HeadlessContext() = default;

Result<HeadlessContext> HeadlessContext::create() {
    std::string reason = "no OpenGL 3.3 was found";
    if (epoxy_has_egl()) {
        for (EGLDisplay display : displays()) {
            auto native = std::make_unique<Native>();
            native->display = display;
            native->context = openGl(display);
            if (native->context == EGL_NO_CONTEXT || !native->makeCurrent())
                continue;
            auto gl = GlContext::current();
            if (gl)
                return HeadlessContext(std::move(native), std::move(*gl));
            reason = gl.error().message;
        }
    }
    return Error{ErrorCode::Unsupported,
                 "cannot draw with OpenGL: " + reason +
                     "; please install a graphics driver (on Debian, libegl1 and libgl1-mesa-dri)"};
}

void HeadlessContext::makeCurrent() const {
    m_native->makeCurrent();
}

void HeadlessContext::finish() const {
    glFinish();
}

bool HeadlessContext::isLost() const {
    const bool canTell = epoxy_gl_version() >= 45 || epoxy_has_gl_extension("GL_KHR_robustness");
    return canTell && glGetGraphicsResetStatus() != GL_NO_ERROR;
}

} // namespace txn
