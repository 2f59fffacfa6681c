// Fidelity `single`: surfaces by rasterisation, one reflected and one refracted look-up.
#pragma once
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "tukor/gl/program.h"
#include "tukor/gl/surface_buffers.h"
#include "tukor/gl/view.h"
#include "tukor/scene/render_options.h"

namespace tukor::gl {

class SingleDrawer {
public:
    /// Draws every ideally smooth part with the material of the same index, with the environment in
    /// texture unit 0, in front of NDC depth 0.999. `environmentDefine` is
    /// EnvironmentTexture::define().
    void draw(const SurfaceBuffers& surfaces, const std::vector<Material>& materials,
              FresnelForm fresnel, const View& view, const glm::mat3& environmentFromWorld,
              glm::vec2 footprintMiddle, std::string_view environmentDefine);

private:
    const Program& programFor(MaterialKind kind, FresnelForm fresnel,
                              std::string_view environmentDefine);

    std::map<std::string, Program> programs_;  // by their defines; compiled when first used
};

}  // namespace tukor::gl
