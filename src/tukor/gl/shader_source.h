// GLSL ES 3.00 text as the build embeds it, with the files it was put together from.
#pragma once
#include <span>

namespace tukor::gl {

/// `text` begins with #version; its #line directives number the files by their place in `files`.
struct ShaderSource {
    const char* text;
    std::span<const char* const> files;
};

}  // namespace tukor::gl
