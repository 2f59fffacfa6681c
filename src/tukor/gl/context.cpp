#include "tukor/gl/context.h"

#include <cstring>
#include <string_view>

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES3/gl3.h>
#include <fmt/format.h>

#include "tukor/base/error.h"

namespace tukor::gl {

struct Context::State {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;
    EGLDisplay previousDisplay = EGL_NO_DISPLAY;
    EGLContext previous = EGL_NO_CONTEXT;
    EGLSurface previousDraw = EGL_NO_SURFACE;
    EGLSurface previousRead = EGL_NO_SURFACE;

    ~State() {
        if (context == EGL_NO_CONTEXT) return;
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display, context);
        if (previous != EGL_NO_CONTEXT)
            eglMakeCurrent(previousDisplay, previousDraw, previousRead, previous);
        // The display stays initialised: it is shared by all contexts of the process.
    }
};

namespace {

constexpr const char* kRemedy =
    "install a driver (Debian: libegl-mesa0 and libgl1-mesa-dri bring a software one)";

bool listed(const char* list, std::string_view name) {
    const std::string_view all = list == nullptr ? "" : list;
    for (std::size_t at = all.find(name); at != all.npos; at = all.find(name, at + 1)) {
        const std::size_t end = at + name.size();
        if ((at == 0 || all[at - 1] == ' ') && (end == all.size() || all[end] == ' ')) return true;
    }
    return false;
}

EGLDisplay initialised(EGLDisplay display) {
    return display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) == EGL_TRUE
               ? display
               : EGL_NO_DISPLAY;
}

EGLDisplay openDisplay() {
    const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    const auto platformDisplay = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
        eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (platformDisplay == nullptr) return EGL_NO_DISPLAY;
    if (listed(extensions, "EGL_MESA_platform_surfaceless")) {
        const EGLDisplay display = initialised(
            platformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
        if (display != EGL_NO_DISPLAY) return display;
    }
    const auto queryDevices =
        reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
    if (queryDevices == nullptr) return EGL_NO_DISPLAY;
    EGLDeviceEXT devices[16];  // more than a machine has
    EGLint count = 0;
    if (queryDevices(16, devices, &count) != EGL_TRUE) return EGL_NO_DISPLAY;
    for (EGLint i = 0; i < count; ++i) {
        const EGLDisplay display =
            initialised(platformDisplay(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr));
        if (display != EGL_NO_DISPLAY) return display;
    }
    return EGL_NO_DISPLAY;
}

EGLContext createContext(EGLDisplay display) {
    if (eglBindAPI(EGL_OPENGL_ES_API) != EGL_TRUE) return EGL_NO_CONTEXT;
    const EGLint wanted[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_ES3_BIT, EGL_SURFACE_TYPE, 0,
                             EGL_NONE};
    EGLConfig config = EGL_NO_CONFIG_KHR;  // where there is none to choose, none may do
    EGLint count = 0;
    if (eglChooseConfig(display, wanted, &config, 1, &count) != EGL_TRUE || count < 1)
        config = EGL_NO_CONFIG_KHR;
    const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 0, EGL_NONE};
    return eglCreateContext(display, config, EGL_NO_CONTEXT, version);
}

}  // namespace

Context::Context() : state_(std::make_unique<State>()) {
    state_->previousDisplay = eglGetCurrentDisplay();
    state_->previous = eglGetCurrentContext();
    state_->previousDraw = eglGetCurrentSurface(EGL_DRAW);
    state_->previousRead = eglGetCurrentSurface(EGL_READ);

    state_->display = openDisplay();
    if (state_->display == EGL_NO_DISPLAY)
        throw Error(fmt::format(
            "no EGL display: neither the surfaceless platform nor an EGL device opens; {}",
            kRemedy));
    state_->context = createContext(state_->display);
    if (state_->context == EGL_NO_CONTEXT)
        throw Error(fmt::format("EGL by {}: no OpenGL ES 3 context; {}",
                                eglQueryString(state_->display, EGL_VENDOR), kRemedy));
    if (eglMakeCurrent(state_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, state_->context) !=
        EGL_TRUE)
        throw Error(fmt::format("EGL by {}: a context cannot be current without a surface; {}",
                                eglQueryString(state_->display, EGL_VENDOR), kRemedy));
    watchErrors(&Context::procAddress);
    requireFeatures();
}

Context::~Context() = default;

void (*Context::procAddress(const char* name))() {
    return eglGetProcAddress(name);
}

}  // namespace tukor::gl
