// What rough surfaces see of the environment: the chain of exactly filtered cube maps, and the
// table of the other half of the split sum, as textures; what lies blurred behind a scene, and what
// lights a ground.
#pragma once
#include "tukor/environment/environment.h"
#include "tukor/environment/lit_directions.h"
#include "tukor/gl/finish_parts.h"
#include "tukor/gl/handles.h"

namespace tukor::gl {

/// Remembers an environment and filters it when a rough surface first asks.
class LightChain {
public:
    LightChain() = default;
    /// `scale` as in EnvironmentTexture: what a texel's radiance was divided by.
    LightChain(const Environment& environment, float scale);

    /// Binds the chain to a texture unit, the table to the next; makes them where they are not.
    void bind(int unit);

    /// Binds what lies behind a scene blurred by this perceptual roughness; the level to look at.
    [[nodiscard]] float bindBlurred(int unit, float roughness);

    /// Binds the directions from which a ground is lit, which traced.frag asks, beside `lamps`, in
    /// the environment's own axes; the irradiance of the ground, of environment and lamps, in units
    /// of texels.
    [[nodiscard]] glm::vec3 bindGround(int unit, std::span<const LitDirection> lamps);

    /// Whether chain and table are there.
    [[nodiscard]] bool ready() const noexcept { return chain_.id() != 0; }
    [[nodiscard]] bool groundReady() const noexcept { return ground_.id() != 0; }
    [[nodiscard]] const LightSource& source() const noexcept { return source_; }
    [[nodiscard]] float scale() const noexcept { return scale_; }

private:
    LightSource source_;
    float scale_ = 1.0f;
    Texture chain_;
    Texture table_;
    Texture backdrop_;
    float backdropRoughness_ = 0.0f;  // of backdrop_
    Texture ground_;
    glm::vec3 groundIrradiance_{0.0f};
    std::vector<LitDirection> groundLamps_;
};

}  // namespace tukor::gl
