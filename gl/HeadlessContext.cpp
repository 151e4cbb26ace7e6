// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/HeadlessContext.h"

#include <algorithm>
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
    EGLSurface surface = EGL_NO_SURFACE; ///< only where a context needs one; nothing is drawn there

    Native() = default;
    Native(const Native&) = delete;
    Native& operator=(const Native&) = delete;
    ~Native() {
        if (context != EGL_NO_CONTEXT) {
            if (eglGetCurrentContext() == context)
                eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
            eglDestroyContext(display, context);
        }
        if (surface != EGL_NO_SURFACE)
            eglDestroySurface(display, surface);
    }
    /// Makes an OpenGL 3.3 core context on an initialised display, and makes it current.
    bool open(EGLDisplay on, bool surfaceless);
    bool makeCurrent() const {
        return eglMakeCurrent(display, surface, surface, context) == EGL_TRUE;
    }
};

namespace {

/// Whether a list, separated by spaces, holds a name.
bool listed(const char* extensions, std::string_view name) {
    std::string_view rest = extensions != nullptr ? extensions : "";
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find(' '), rest.size());
        if (rest.substr(0, end) == name)
            return true;
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return false;
}

/// Graphics cards first, then Mesa without a card, then whatever the system thinks best. A function
/// that the system's EGL lacks must not be called.
std::vector<EGLDisplay> displays() {
    std::vector<EGLDisplay> found;
    const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    const bool platforms = listed(extensions, "EGL_EXT_platform_base");
    const bool devices = listed(extensions, "EGL_EXT_device_base") ||
                         (listed(extensions, "EGL_EXT_device_enumeration") &&
                          listed(extensions, "EGL_EXT_device_query"));
    if (platforms && devices && listed(extensions, "EGL_EXT_platform_device")) {
        std::array<EGLDeviceEXT, 16> all{};
        EGLint count = 0;
        if (eglQueryDevicesEXT(static_cast<EGLint>(all.size()), all.data(), &count)) {
            for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
                if (!listed(eglQueryDeviceStringEXT(all[i], EGL_EXTENSIONS),
                            "EGL_MESA_device_software"))
                    found.push_back(
                        eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, all[i], nullptr));
            }
        }
    }
    if (platforms && listed(extensions, "EGL_MESA_platform_surfaceless"))
        found.push_back(
            eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
    found.push_back(eglGetDisplay(EGL_DEFAULT_DISPLAY));
    return found;
}

/// A configuration for OpenGL whose surfaces can be of those types, or none.
EGLConfig configuration(EGLDisplay display, EGLint surfaceTypes) {
    const std::array<EGLint, 5> wanted{EGL_RENDERABLE_TYPE,
                                       EGL_OPENGL_BIT,
                                       EGL_SURFACE_TYPE,
                                       surfaceTypes,
                                       EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    return eglChooseConfig(display, wanted.data(), &config, 1, &count) && count > 0 ? config
                                                                                    : nullptr;
}

/// An OpenGL 3.3 core context, or none.
EGLContext coreContext(EGLDisplay display, EGLConfig config) {
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

bool HeadlessContext::Native::open(EGLDisplay on, bool surfaceless) {
    display = on;
    const char* extensions = eglQueryString(display, EGL_EXTENSIONS);
    if (surfaceless && !listed(extensions, "EGL_KHR_surfaceless_context"))
        return false;
    const bool needsConfig = !surfaceless || (!listed(extensions, "EGL_KHR_no_config_context") &&
                                              !listed(extensions, "EGL_MESA_configless_context"));
    EGLConfig config = EGL_NO_CONFIG_KHR;
    if (needsConfig) {
        config = configuration(display, surfaceless ? 0 : EGL_PBUFFER_BIT);
        if (config == nullptr)
            return false;
    }
    if (!surfaceless) {
        constexpr std::array<EGLint, 5> kPixel{EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE};
        surface = eglCreatePbufferSurface(display, config, kPixel.data());
        if (surface == EGL_NO_SURFACE)
            return false;
    }
    context = coreContext(display, config);
    return context != EGL_NO_CONTEXT && makeCurrent();
}

HeadlessContext::HeadlessContext(std::unique_ptr<Native> native, GlContext gl)
    : m_native(std::move(native)), m_gl(std::make_unique<GlContext>(std::move(gl))) {}
HeadlessContext::HeadlessContext(HeadlessContext&&) noexcept = default;
HeadlessContext& HeadlessContext::operator=(HeadlessContext&&) noexcept = default;
HeadlessContext::~HeadlessContext() = default;

Result<HeadlessContext> HeadlessContext::create() {
    std::string reason = "no OpenGL 3.3 was found";
    if (epoxy_has_egl()) {
        for (EGLDisplay display : displays()) {
            if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr) ||
                !eglBindAPI(EGL_OPENGL_API))
                continue;
            // Some drivers draw only with a surface at hand, though they may promise otherwise.
            for (const bool surfaceless : {true, false}) {
                auto native = std::make_unique<Native>();
                if (!native->open(display, surfaceless))
                    continue;
                auto gl = GlContext::current();
                if (gl)
                    return HeadlessContext(std::move(native), std::move(*gl));
                reason = gl.error().message;
            }
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
