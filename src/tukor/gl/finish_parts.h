// What only surfaces with a Finish, a ground or dispersion need, and little of that little:
// programs have it built in, a page fetches it once there is one.
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "tukor/environment/cube_map.h"
#include "tukor/environment/lit_directions.h"
#include "tukor/gl/shader_source.h"
#include "tukor/image/image.h"

namespace tukor::gl {

/// Levels of the chain; level i holds the perceptual roughness i / (kChainLevels - 1). The last is
/// irradiance over pi.
inline constexpr int kChainLevels = 6;
inline constexpr int kChainFaceSize = 256;  // of level 0
inline constexpr int kTableSize = 32;

/// An environment: its panorama, or else its cube map.
struct LightSource {
    std::shared_ptr<const Image> panorama;
    std::shared_ptr<const CubeMap> cube;
    std::shared_ptr<const Image> unrolled = nullptr;  // the cube map as a panorama, once asked for
};

/// Texels as textures hold them: four half floats each.
struct FinishLight {
    std::vector<std::uint64_t> chain;  // level by level, six faces each
    std::vector<std::uint64_t> table;  // of the split sum
};

/// Radiance is divided by `scale` first, see EnvironmentTexture.
[[nodiscard]] FinishLight finishLight(LightSource& source, float scale);

/// A cube map, face by face, four half floats a texel.
struct BackdropLight {
    int faceSize = 0;
    std::vector<std::uint64_t> texels;
};

/// What lies behind a scene blurred by this perceptual roughness. Nothing in a page, which has to
/// do with the chain.
[[nodiscard]] BackdropLight backdropLight(LightSource& source, float scale, float roughness);

inline constexpr std::size_t kLitDirections = 4096;  // as traced.frag has it

/// What lights a ground, as traced.frag has it: that many directions, in the environment's axes,
/// and after each the irradiance of the ground if all light came from there. Nothing where all is
/// dark. A page has the environment's alone, without the `lamps`.
[[nodiscard]] std::vector<glm::vec4> groundLight(const LightSource& source, float scale,
                                                 std::span<const LitDirection> lamps);

/// optics::visibleSpectrum() as traced.frag has it: nm and weights.
[[nodiscard]] std::vector<glm::vec4> spectrumTable();

/// Whether spectrum and shaders are there: in a page, once they were fetched.
[[nodiscard]] bool partsAtHand() noexcept;

/// finish.frag.
[[nodiscard]] const ShaderSource& finishShader();

/// traced.frag with its branches for FINISHES, GROUND and DISPERSION.
[[nodiscard]] const ShaderSource& wholeTracedShader();

}  // namespace tukor::gl
