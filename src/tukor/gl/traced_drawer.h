// Fidelity `double` and `exact`: the light-path tree of every pixel, traced in a fragment shader.
#pragma once
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tukor/gl/environment_texture.h"
#include "tukor/gl/frame_buffers.h"
#include "tukor/gl/traced_scene.h"
#include "tukor/gl/view.h"
#include "tukor/scene/render_options.h"

namespace tukor::gl {

class TracedDrawer {
public:
    /// How light and shadows on the ground come about: traced, known by place from a GroundLight,
    /// or gathered for one.
    enum class GroundUse { traced, known, gathered };
    /// A square of ground, and how it is lit where nothing shadows it, in units of the frame.
    struct Ground {
        glm::vec3 middle;
        float halfWidth;
        glm::vec3 irradiance;
        GroundUse use;
        float level = 0.0f;  // of what is known
    };
    /// One frame: `options` but with the fidelity and Fresnel form given beside it.
    struct Frame {
        const View& view;
        const PictureWindow& window;
        const RenderOptions& options;
        Fidelity fidelity;
        FresnelForm fresnel;
        glm::mat3 environmentFromWorld;
        float footprintScale;  // distance of neighbouring samples, in pixels
        bool splitGrazing;     // see transport/grazing.h
        int number;            // 0: the first of the sum
        bool centred;          // looks through the middles of pixels
        bool firstHitsKnown;   // drawn by drawFirstHits() with the same view
        const std::vector<Light>& lights;
        float emissionFactor;  // from radiance to units of the frame
        std::optional<Ground> ground;
    };
    /// Texture units of what the renderer has bound: the sum, its counts beside it, what was drawn
    /// of surfaces with a finish, the light chain and its table, the first hits, what lights the
    /// ground, and its light by place.
    struct Units {
        int sum;
        int raster;
        int chain;
        int firstHits;
        int ground;
        int groundLight;
    };
    /// The region of the bound framebuffer to draw.
    struct Region {
        int left;
        int bottom;
        int width;
        int height;
    };

    /// The triangle in the middle of every pixel, into the bound numbers. All of the scene lies
    /// beyond the near plane.
    void drawFirstHits(const TracedScene& scene, const View& view);

    /// Adds the frame to the sum and writes the result into the bound framebuffer; in tiles, so
    /// that no draw call lasts long. Where the scene has finishes all pixels look through the same
    /// place: that of the view, with which they were drawn.
    void draw(TracedScene& scene, const EnvironmentTexture& environment, const Frame& frame,
              Counting counting, const Units& units, const Region& region);

private:
    const Program& programFor(Fidelity fidelity, FresnelForm fresnel, const ShaderSource& shader,
                              std::string_view sceneDefines, Counting counting);

    std::optional<Program> firstHitProgram_;
    std::map<std::string, Program> programs_;  // by their defines; compiled when first used
};

}  // namespace tukor::gl
