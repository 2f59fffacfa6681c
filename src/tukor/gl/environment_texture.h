// The environment as a cube texture of half floats.
#pragma once
#include "tukor/environment/cube_map.h"
#include "tukor/gl/handles.h"

namespace tukor::gl {

/// Level 0 is filled at once, the mip levels when they are first asked for: only `exact` reads
/// them.
class EnvironmentTexture {
public:
    EnvironmentTexture() = default;
    explicit EnvironmentTexture(const CubeMap& cube);

    /// Binds it to a texture unit, counted from 0.
    void bind(int unit) const;

    /// Fills the levels above 0 with means over solid angle of the map it was made from, once.
    void needLevels(const CubeMap& cube);

    /// Radiance is a texel times this power of two: half floats end at 65504, suns do not.
    [[nodiscard]] float scale() const noexcept { return scale_; }
    [[nodiscard]] int faceSize() const noexcept { return faceSize_; }
    [[nodiscard]] int levels() const noexcept { return levels_; }

private:
    Texture texture_;
    float scale_ = 1.0f;
    int faceSize_ = 0;
    int levels_ = 1;
    bool filled_ = false;
};

}  // namespace tukor::gl
