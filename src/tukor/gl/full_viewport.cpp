#include "tukor/gl/full_viewport.h"

#include "tukor/base/error.h"
#include "tukor/gl/errors.h"

namespace tukor::gl {

void drawFullViewport(const Program& program) {
    program.use();
    glBindVertexArray(0);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

std::vector<glm::vec4> runFullViewport(const Program& program, int width, int height) {
    const Texture target = Texture::make();
    glActiveTexture(GL_TEXTURE0 + 15);  // not a unit that callers use
    glBindTexture(GL_TEXTURE_2D, target.id());
    glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA32F, width, height);
    const Framebuffer framebuffer = Framebuffer::make();
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target.id(), 0);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw Error("the OpenGL driver cannot render to 32-bit floats (EXT_color_buffer_float)");
    glViewport(0, 0, width, height);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
    glDisable(GL_SCISSOR_TEST);
    drawFullViewport(program);
    std::vector<glm::vec4> pixels(static_cast<std::size_t>(width) *
                                  static_cast<std::size_t>(height));
    glReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, pixels.data());
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    throwPendingErrors("running a program over a viewport");
    return pixels;
}

}  // namespace tukor::gl
