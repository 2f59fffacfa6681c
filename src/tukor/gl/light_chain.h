// What rough surfaces see of the environment: the chain of exactly filtered cube maps, and the
// table of the other half of the split sum, as textures.
#pragma once
#include "tukor/environment/environment.h"
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

    /// Whether they are there.
    [[nodiscard]] bool ready() const noexcept { return chain_.id() != 0; }
    [[nodiscard]] const LightSource& source() const noexcept { return source_; }
    [[nodiscard]] float scale() const noexcept { return scale_; }

private:
    LightSource source_;
    float scale_ = 1.0f;
    Texture chain_;
    Texture table_;
};

}  // namespace tukor::gl
