// One element's scene, light and picture: what the functions of exports.cpp act on.
#pragma once
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tukor/app/options.h"
#include "tukor/app/pace.h"
#include "tukor/environment/environment.h"
#include "tukor/gl/renderer.h"
#include "tukor/scene/scene.h"

namespace tukor::web {

/// Draws into the WebGL 2 context that is current when it is made. Functions throw Error.
class Viewer {
public:
    Viewer();

    void setScene(Scene scene);
    /// The same parts elsewhere, of the materials that they have; false, and nothing done, when
    /// they are not the same.
    bool setPose(Scene scene);
    /// `NAME` or `PATTERN=NAME`, separated by semicolons; all others get back their own. A factor
    /// on the dispersion of all; below zero it stays as it is.
    void setMaterials(std::string_view specifications, float dispersion);
    /// False, and nothing done, when the picture is not twice as wide as high.
    bool setPanorama(Image picture);
    /// Three floats a texel, face after face as in CubeMap.
    void setCube(const float* texels, int faceSize);

    /// `fidelity`, `fresnel`, `background` or `tone-map`, as `tukor render` spells their values.
    void setOption(std::string_view name, std::string_view text);
    /// Rotation in radians about +Y, factor on radiance.
    void setLight(float rotation, float intensity) noexcept;
    /// Suns beside the model's own, six figures each: where its light comes from, and the colour of
    /// a white matt surface that faces it. Another scene has none.
    void setSuns(std::span<const float> figures);
    /// Events along one branch of the light path, at fidelities that trace rays.
    void setMaxDepth(int depth) noexcept { options_.maxDepth = depth; }
    /// From 0, sharp, to 1.
    void setBackgroundBlur(float blur) noexcept { options_.backgroundBlur = blur; }
    /// A height in metres, or negative infinity for the lowest point of the model; positive: none.
    void setGround(float height) noexcept { ground_ = height; }
    void setExposure(float stops) noexcept { display_.exposureStops = stops; }
    void setCamera(const Camera& camera) noexcept { camera_ = camera; }

    /// Draws one more frame of the picture into the canvas. Returns the samples in it.
    int drawFrame(int width, int height);
    /// Draws one that will be followed by others: as fine as the pace allows.
    int drawMoving(int width, int height);
    /// How long a frame of drawMoving() took, in seconds.
    void took(double seconds) noexcept { pace_.took(seconds); }
    /// The picture anew from the next frame on.
    void restart() noexcept { renderer_.resetAccumulation(); }

    /// One more frame of a picture of another size, which is not shown and is to have so many
    /// samples a pixel. Returns those in it.
    int drawStill(int width, int height, int samples);
    /// That picture as straight-alpha sRGB, four bytes a pixel from the top left; valid until the
    /// next call.
    [[nodiscard]] std::span<const std::uint8_t> stillPixels();

    /// See tukor_light_wanted().
    [[nodiscard]] std::string lightWanted() const;

    /// 1 + the index of the part under a place in the picture, from (0, 0) top left to (1, 1); 0
    /// for none.
    [[nodiscard]] int pick(float x, float y, float aspect) const;

    [[nodiscard]] Camera framing(float aspect) const noexcept;
    [[nodiscard]] const Scene& scene() const noexcept { return scene_; }
    [[nodiscard]] std::vector<std::string> warnings() const;

private:
    [[nodiscard]] gl::FrameOptions frameOptions(int width, int height) const noexcept;
    void useEnvironment(Environment environment);

    int present(int width, int height);

    gl::Renderer renderer_;
    Pace pace_;
    RenderOptions options_;
    float ground_ = std::numeric_limits<float>::infinity();
    float lowest_ = 0.0f;  // of the scene
    gl::DisplayOptions display_;
    Scene scene_;
    std::size_t ownLights_ = 0;           // before setSuns()
    std::vector<Material> ownMaterials_;  // the parts' before setMaterials()
    std::vector<std::string> environmentWarnings_;
    Camera camera_;
    std::vector<std::uint8_t> pixels_;
};

}  // namespace tukor::web
