// Fidelity `single` of surfaces that are not ideally smooth: rough, diffuse, textured.
#pragma once
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tukor/gl/light_chain.h"
#include "tukor/gl/program.h"
#include "tukor/gl/surface_buffers.h"
#include "tukor/gl/view.h"
#include "tukor/scene/finish.h"
#include "tukor/scene/scene.h"

namespace tukor::gl {

/// What one frame shares. Textures 0: the environment; 1 and 2: the light chain.
struct FinishFrame {
    const View& view;
    glm::mat3 environmentFromWorld;
    glm::vec2 footprintMiddle;
    std::string_view environmentDefine;
    float emissionFactor;  // from radiance to units of the frame
    const std::vector<Light>& lights;
};

class FinishDrawer {
public:
    /// Draws the opaque parts that have a finish, or the blended ones, from far to near. The
    /// environment is bound to unit 0, the vertex array is not bound.
    enum class Pass { opaque, blended };
    void draw(const SurfaceBuffers& surfaces, const std::vector<Material>& materials, Pass pass,
              LightChain& light, const FinishFrame& frame);

    /// Forgets the textures of another scene.
    void clear() { textures_.clear(); }

private:
    enum class Solidity { thin, solid };
    void drawPart(const SurfaceBuffers& surfaces, int part, const Finish& finish, Solidity solidity,
                  float eta, const FinishFrame& frame);
    const Program& programFor(const std::string& defines);
    const Texture& textureOf(const TextureMap& map, TextureRole role);

    std::map<std::string, Program> programs_;  // by their defines
    std::map<std::pair<std::shared_ptr<const Texels>, bool>, Texture> textures_;  // sRGB or not
};

}  // namespace tukor::gl
