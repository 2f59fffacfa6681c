// Tables of numbers that shaders read one by one.
#pragma once
#include <cstddef>

#include "tukor/gl/handles.h"

namespace tukor::gl {

/// A texture of `texels` in rows of `width`, unfiltered; uses texture unit 0. Throws Error for more
/// rows than the driver has.
[[nodiscard]] Texture makeTable(GLenum internal, GLenum format, GLenum type, int width,
                                std::size_t texels, const void* data);

}  // namespace tukor::gl
