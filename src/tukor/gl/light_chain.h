// What rough surfaces see of the environment: the chain of exactly filtered cube maps, and the
// table of the other half of the split sum, as textures.
#pragma once
#include <memory>

#include "tukor/environment/environment.h"
#include "tukor/gl/handles.h"

namespace tukor::gl {

/// Levels of the chain; level i holds the perceptual roughness i / (kChainLevels - 1). The last is
/// irradiance over pi.
inline constexpr int kChainLevels = 6;

/// Remembers an environment and filters it when a rough surface first asks.
class LightChain {
public:
    LightChain() = default;
    /// `scale` as in EnvironmentTexture: what a texel's radiance was divided by.
    LightChain(const Environment& environment, float scale);

    /// Binds the chain to a texture unit, the table to the next; makes them where they are not.
    void bind(int unit);

private:
    std::shared_ptr<const Image> panorama_;
    float scale_ = 1.0f;
    Texture chain_;
    Texture table_;
};

}  // namespace tukor::gl
