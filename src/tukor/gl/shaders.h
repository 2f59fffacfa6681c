// The shaders of gl/shaders, made by cmake/EmbedShader.cmake: `background.frag` is backgroundFrag.
#pragma once
#include "tukor/gl/shader_source.h"

namespace tukor::gl::shaders {

extern const ShaderSource accumulateFrag;
extern const ShaderSource backgroundFrag;
extern const ShaderSource backgroundShellVert;
extern const ShaderSource backgroundVert;
extern const ShaderSource behindFrag;
extern const ShaderSource finishFrag;
extern const ShaderSource finishVert;
extern const ShaderSource firstHitFrag;
extern const ShaderSource firstHitVert;
extern const ShaderSource fullViewportVert;
extern const ShaderSource presentFrag;
extern const ShaderSource surfaceFrag;
extern const ShaderSource surfaceVert;
extern const ShaderSource tracedFrag;

}  // namespace tukor::gl::shaders
