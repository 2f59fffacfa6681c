// What the module asks of a context, whoever made it.
#include <cstring>

#include <GLES3/gl3.h>
#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/gl/context.h"

namespace tukor::gl {

namespace {

bool canRenderTo(GLenum format) {
    GLuint texture = 0;
    GLuint framebuffer = 0;
    glGenTextures(1, &texture);
    glGenFramebuffers(1, &framebuffer);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexStorage2D(GL_TEXTURE_2D, 1, format, 1, 1);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    const bool complete = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteTextures(1, &texture);
    return complete;
}

}  // namespace

void requireFeatures() {
    const auto text = [](GLenum name) {
        const GLubyte* value = glGetString(name);
        return value == nullptr ? "unknown" : reinterpret_cast<const char*>(value);
    };
    GLint major = 0;
    glGetIntegerv(GL_MAJOR_VERSION, &major);
    if (std::strncmp(text(GL_VERSION), "OpenGL ES", 9) != 0 || major < 3)
        throw Error(fmt::format("{}: {}; OpenGL ES 3.0 or WebGL 2 is needed", text(GL_RENDERER),
                                text(GL_VERSION)));
    if (!canRenderTo(GL_RGBA32F) || !canRenderTo(GL_RGBA16F))
        throw Error(
            fmt::format("{}: cannot render to float textures; EXT_color_buffer_float is needed",
                        text(GL_RENDERER)));
    while (glGetError() != GL_NO_ERROR) {  // a refused format is an answer, not an error
    }
}

}  // namespace tukor::gl
