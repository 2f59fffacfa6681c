#include "tukor/gl/errors.h"

#include <cstring>
#include <string>
#include <utility>

#include <GLES3/gl3.h>
#include <fmt/format.h>

#include "tukor/base/error.h"

#ifndef __EMSCRIPTEN__
#include <GLES2/gl2ext.h>  // wants gl3.h before it
#endif

namespace tukor::gl {

namespace {

thread_local std::string pending;

#ifdef GL_KHR_debug
void GL_APIENTRY storeError(GLenum, GLenum type, GLuint, GLenum, GLsizei length, const GLchar* text,
                            const void*) noexcept {
    if (type != GL_DEBUG_TYPE_ERROR_KHR || !pending.empty()) return;
    try {
        pending = length >= 0 ? std::string(text, static_cast<std::size_t>(length)) : text;
    } catch (...) {  // out of memory: glGetError still tells
    }
}
#endif

[[maybe_unused]] bool hasExtension(const char* name) {
    GLint count = 0;
    glGetIntegerv(GL_NUM_EXTENSIONS, &count);
    for (GLint i = 0; i < count; ++i) {
        const GLubyte* one = glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(i));
        if (one != nullptr && std::strcmp(reinterpret_cast<const char*>(one), name) == 0)
            return true;
    }
    return false;
}

const char* errorName(GLenum error) {
    switch (error) {
        case GL_INVALID_ENUM:
            return "invalid enum";
        case GL_INVALID_VALUE:
            return "invalid value";
        case GL_INVALID_OPERATION:
            return "invalid operation";
        case GL_INVALID_FRAMEBUFFER_OPERATION:
            return "incomplete framebuffer";
        case GL_OUT_OF_MEMORY:
            return "out of memory";
        default:
            return "unknown error";
    }
}

}  // namespace

void watchErrors([[maybe_unused]] ProcAddress procAddress) {
#ifdef GL_KHR_debug
    if (procAddress == nullptr || !hasExtension("GL_KHR_debug")) return;
    const auto callback = reinterpret_cast<PFNGLDEBUGMESSAGECALLBACKKHRPROC>(
        procAddress("glDebugMessageCallbackKHR"));
    if (callback == nullptr) return;
    glEnable(GL_DEBUG_OUTPUT_KHR);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS_KHR);  // on this thread, inside the call that failed
    callback(storeError, nullptr);
#endif
}

void throwPendingErrors(std::string_view doing) {
    const std::string text = std::exchange(pending, {});
    const GLenum first = glGetError();
    while (glGetError() != GL_NO_ERROR) {  // one flag a context in practice; clear them all
    }
    if (text.empty() && first == GL_NO_ERROR) return;
    throw Error(fmt::format("OpenGL failed while {}: {}", doing,
                            text.empty() ? errorName(first) : text.c_str()));
}

}  // namespace tukor::gl
