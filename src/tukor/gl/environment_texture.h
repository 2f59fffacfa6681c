// The environment as a texture of half floats: the panorama it came from, or else its cube map.
#pragma once
#include <string_view>

#include "tukor/environment/environment.h"
#include "tukor/gl/handles.h"

namespace tukor::gl {

/// What is made ready: `single` does without the mip levels of the environment and without a tree
/// over the triangles.
enum class Preparation { single, all };

/// The mip levels are filled with level 0, or never: `single` does not read them.
class EnvironmentTexture {
public:
    EnvironmentTexture() = default;
    EnvironmentTexture(const Environment& environment, Preparation preparation);

    /// Binds it to a texture unit, counted from 0.
    void bind(int unit) const;

    /// For shaders with `uniform environment`: which of the two it is, as a #define.
    [[nodiscard]] std::string_view define() const noexcept {
        return panorama_ ? "#define PANORAMA 1\n" : "#define PANORAMA 0\n";
    }

    /// Radiance is a texel times this power of two: half floats end at 65504, suns do not.
    [[nodiscard]] float scale() const noexcept { return scale_; }

    /// Texels per edge of a cube map with as many texels to the degree.
    [[nodiscard]] int faceSize() const noexcept { return faceSize_; }

private:
    void uploadPanorama(const Image& panorama, Preparation preparation);
    void uploadCube(const CubeMap& cube, Preparation preparation);

    Texture texture_;
    bool panorama_ = false;
    float scale_ = 1.0f;
    int faceSize_ = 0;
};

}  // namespace tukor::gl
