// Fidelity `single`: surfaces by rasterisation, one reflected and one refracted look-up.
#pragma once
#include <map>
#include <vector>

#include "tukor/gl/program.h"
#include "tukor/gl/surface_buffers.h"
#include "tukor/gl/view.h"
#include "tukor/scene/render_options.h"

namespace tukor::gl {

class SingleDrawer {
public:
    /// Draws every part with the material of the same index, with the environment in texture unit
    /// 0, in front of NDC depth 0.999.
    void draw(const SurfaceBuffers& surfaces, const std::vector<Material>& materials,
              FresnelForm fresnel, const View& view, const glm::mat3& environmentFromWorld,
              glm::vec2 footprintMiddle);

private:
    const Program& programFor(MaterialKind kind, FresnelForm fresnel);

    std::map<std::pair<MaterialKind, FresnelForm>, Program> programs_;  // compiled when first used
};

}  // namespace tukor::gl
