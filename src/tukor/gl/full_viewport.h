// Programs run once for every pixel of a float picture: how GLSL is used as a calculator.
#pragma once
#include <vector>

#include <glm/glm.hpp>

#include "tukor/gl/program.h"

namespace tukor::gl {

/// Draws one triangle over the whole viewport; the program's vertex shader is fullViewportVert.
void drawFullViewport(const Program& program);

/// The RGBA outputs, unrounded 32-bit floats, of a width x height viewport; row 0 is the one with
/// gl_FragCoord.y = 0.5.
///
/// Uniforms and textures are set before. Leaves the default framebuffer bound.
[[nodiscard]] std::vector<glm::vec4> runFullViewport(const Program& program, int width, int height);

}  // namespace tukor::gl
