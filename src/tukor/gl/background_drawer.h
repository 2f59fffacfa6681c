// The environment behind the scene: full-viewport quad, sky box, sky dome.
#pragma once
#include <memory>

#include "tukor/gl/handles.h"
#include "tukor/gl/program.h"
#include "tukor/gl/view.h"
#include "tukor/scene/render_options.h"

namespace tukor::gl {

class BackgroundDrawer {
public:
    /// Draws into the bound framebuffer at NDC depth 0.999, with the environment in texture unit 0.
    /// `faceSize` is the environment's.
    void draw(Background background, const View& view, const glm::mat3& environmentFromWorld,
              glm::vec2 footprintMiddle, int faceSize);

private:
    /// Triangles around the origin, of any radius.
    struct Shell {
        VertexArray vertexArray;
        Buffer vertices;
        GLsizei count = 0;
    };
    [[nodiscard]] static Shell makeShell(Background background);

    std::unique_ptr<Program> quad_;
    std::unique_ptr<Program> shell_;
    Shell box_;
    Shell dome_;
};

}  // namespace tukor::gl
