// The shaders of gl/shaders, made by cmake/EmbedShader.cmake: `background.frag` is backgroundFrag.
#pragma once
#include "tukor/gl/shader_source.h"

namespace tukor::gl::shaders {

extern const ShaderSource fullViewportVert;

}  // namespace tukor::gl::shaders
