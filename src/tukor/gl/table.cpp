#include "tukor/gl/table.h"

#include <fmt/format.h>

#include "tukor/base/error.h"

namespace tukor::gl {

Texture makeTable(GLenum internal, GLenum format, GLenum type, int width, std::size_t texels,
                  const void* data) {
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    const std::size_t height = texels / static_cast<std::size_t>(width);
    if (height > static_cast<std::size_t>(largest))
        throw Error(
            fmt::format("too many triangles for this OpenGL driver: textures of at most {} rows; "
                        "trace takes more",
                        largest));
    Texture texture = Texture::make();
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, texture.id());
    glTexStorage2D(GL_TEXTURE_2D, 1, internal, width, static_cast<GLsizei>(height));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, static_cast<GLsizei>(height), format, type,
                    data);
    return texture;
}

}  // namespace tukor::gl
