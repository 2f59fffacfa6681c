// The environment behind the scene: full-viewport quad, sky box, sky dome.
#pragma once
#include <map>
#include <optional>
#include <string_view>

#include "tukor/gl/environment_texture.h"
#include "tukor/gl/handles.h"
#include "tukor/gl/program.h"
#include "tukor/gl/view.h"
#include "tukor/scene/render_options.h"

namespace tukor::gl {

class BackgroundDrawer {
public:
    /// Draws into the bound framebuffer at NDC depth 0.999, with the environment in texture unit 0.
    void draw(Background background, const View& view, const glm::mat3& environmentFromWorld,
              glm::vec2 footprintMiddle, const EnvironmentTexture& environment);

    /// Adds it, blurred, to a sum of `frames` frames without background. The sum is in texture unit
    /// 0, a cube map in 1, of which `level` is shown.
    void drawBehind(int frames, const View& view, const glm::mat3& environmentFromWorld,
                    float level);

private:
    /// Triangles around the origin, of any radius.
    struct Shell {
        VertexArray vertexArray;
        Buffer vertices;
        GLsizei count = 0;
    };
    [[nodiscard]] static Shell makeShell(Background background);

    /// Compiled when first used; by shape and kind of environment.
    std::map<std::pair<bool, std::string_view>, Program> programs_;
    std::optional<Program> behind_;
    Shell box_;
    Shell dome_;
};

}  // namespace tukor::gl
