// Environments blurred for rough surfaces: chains of cube maps, irradiance, backgrounds.
#pragma once
#include <optional>
#include <utility>
#include <vector>

#include "tukor/base/options.h"
#include "tukor/base/progress.h"
#include "tukor/environment/cube_map.h"
#include "tukor/environment/lobe.h"
#include "tukor/environment/spectrum.h"

namespace tukor {

/// How the levels of a chain divide the range from mirror to fully rough; x runs from 0 to 1.
enum class RoughnessScale {
    filament,  // alpha = (1 - sqrt(1 - x))^2: as Filament's cmgen, finer at the sharp end
    linear,    // alpha = x^2: perceptual roughness x, as glTF viewers expect
};

inline constexpr std::array<std::pair<RoughnessScale, std::string_view>, 2>
    kRoughnessScaleSpellings = {
        {{RoughnessScale::filament, "filament"}, {RoughnessScale::linear, "linear"}}};

struct ChainOptions {
    int faceSize = 256;                // of level 0; each level has half of the one before
    int levels = 5;                    // from 1 on; as many as the face size can be halved, and one
    LobeShape shape = LobeShape::ggx;  // ggx or charlie
    RoughnessScale scale = RoughnessScale::filament;
};

/// Level 0 is the environment itself for ggx. `alphas` has the roughness of each level, squared
/// from the perceptual one.
struct PrefilteredChain {
    std::vector<CubeMap> levels;
    std::vector<double> alphas;
};

/// The alpha of each level.
[[nodiscard]] std::vector<double> chainAlphas(const ChainOptions& options);

/// Within 1e-3 of exact quadrature. Deterministic for any number of threads. An empty chain where
/// `progress` asked to stop.
[[nodiscard]] PrefilteredChain prefilteredChain(const Image& panorama,
                                                const ChainOptions& options = {},
                                                const Progress& progress = {});

/// The panorama convolved with one lobe: ggx, charlie or gaussian of any alpha above 0; lambert
/// gives irradiance over pi. None where `progress` asked to stop.
[[nodiscard]] std::optional<CubeMap> blurredCube(const Image& panorama, const Lobe& lobe,
                                                 int faceSize, const Progress& progress = {});

/// What lies behind a scene whose background is blurred: the panorama as a surface of this
/// perceptual roughness, in (0, 1], shows it, on faces of some texels a lobe. Below 0.1 it is
/// mixed of that of 0.1 and the sharp one.
[[nodiscard]] CubeMap blurredBackdrop(const Image& panorama, float roughness);

}  // namespace tukor
