#include "tukor/gl/single_drawer.h"

#include <fmt/format.h>

#include "tukor/gl/shaders.h"

namespace tukor::gl {

const Program& SingleDrawer::programFor(MaterialKind kind, FresnelForm fresnel,
                                        std::string_view environmentDefine) {
    if (kind == MaterialKind::mirror) fresnel = FresnelForm::exact;  // has none
    const std::string defines =
        fmt::format("#define MATERIAL {}\n#define FRESNEL {}\n{}", static_cast<int>(kind),
                    static_cast<int>(fresnel), environmentDefine);
    const auto found = programs_.find(defines);
    if (found != programs_.end()) return found->second;
    return programs_.emplace(defines, Program(shaders::surfaceVert, shaders::surfaceFrag, defines))
        .first->second;
}

void SingleDrawer::draw(const SurfaceBuffers& surfaces, const std::vector<Material>& materials,
                        FresnelForm fresnel, const View& view,
                        const glm::mat3& environmentFromWorld, glm::vec2 footprintMiddle,
                        std::string_view environmentDefine) {
    // The background's depth, 0.999 in NDC, is 0.9995 here: all that is drawn lies before it.
    glDepthRangef(0.0f, 0.999f);
    surfaces.bind();
    for (int part = 0; part < surfaces.parts(); ++part) {
        const Material& material = materials[static_cast<std::size_t>(part)];
        if (material.finish) continue;  // FinishDrawer's
        const Program& program = programFor(material.kind, fresnel, environmentDefine);
        program.set("clipFromWorld", view.clipFromWorld);
        program.set("environmentFromWorld", environmentFromWorld);
        program.set("eye", view.eye);
        program.set("environment", 0);
        program.set("footprintMiddle", footprintMiddle);
        program.set("tint", material.tint);
        program.set("eta", material.eta);
        program.set("k", material.k);
        surfaces.draw(part, view.eye);
    }
    glBindVertexArray(0);
    glDepthRangef(0.0f, 1.0f);
}

}  // namespace tukor::gl
