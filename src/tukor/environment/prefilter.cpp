#include "tukor/environment/prefilter.h"

#include <algorithm>
#include <cmath>

#include "tukor/base/error.h"
#include "tukor/environment/equirect.h"
#include "tukor/environment/local_gather.h"

namespace tukor {

namespace {

/// Sharper lobes than this need degrees beyond kMaxDegree.
constexpr double kLeastSpectralAlpha = 6.0 / kMaxDegree;

/// Sharper ones take seconds.
constexpr double kLeastBackdropAlpha = 0.01;

CubeMap convolved(const Image& panorama, const Spectrum& spectrum, const Lobe& lobe, int faceSize) {
    if (lobe.shape == LobeShape::ggx && lobe.alpha < kLeastSpectralAlpha)
        return gatheredCube(panorama, lobe, faceSize);
    return cubeFromSpectrum(
        spectrum, lobeFactors(lobe, std::min(lobeDegree(lobe), spectrum.degree())), faceSize);
}

}  // namespace

std::vector<double> chainAlphas(const ChainOptions& options) {
    std::vector<double> alphas;
    for (int level = 0; level < options.levels; ++level) {
        const double x =
            options.levels > 1 ? static_cast<double>(level) / (options.levels - 1) : 0.0;
        const double roughness =
            options.scale == RoughnessScale::filament ? 1.0 - std::sqrt(1.0 - x) : x;
        alphas.push_back(roughness * roughness);
    }
    return alphas;
}

PrefilteredChain prefilteredChain(const Image& panorama, const ChainOptions& options,
                                  const Progress& progress) {
    TUKOR_ASSERT(options.levels >= 1 && options.faceSize >> (options.levels - 1) >= 1);
    PrefilteredChain chain;
    chain.alphas = chainAlphas(options);
    // A sheen of no roughness has no lobe: the sharpest that makes sense stands for it.
    if (options.shape == LobeShape::charlie) chain.alphas[0] = std::max(chain.alphas[0], 0.01);
    int degree = 0;
    for (const double alpha : chain.alphas)
        if (alpha >= kLeastSpectralAlpha)
            degree = std::max(degree, lobeDegree({options.shape, alpha}));
    const auto proceed = [&](double done) {
        return !progress || progress(static_cast<float>(done));
    };
    if (!proceed(0.0)) return {};
    const Spectrum spectrum = spectrumOf(panorama, degree);
    for (int level = 0; level < options.levels; ++level) {
        if (!proceed(0.5 + 0.5 * level / options.levels)) return {};
        const int faceSize = options.faceSize >> level;
        const double alpha = chain.alphas[static_cast<std::size_t>(level)];
        chain.levels.push_back(
            alpha == 0.0 ? cubeFromEquirect(panorama, faceSize)
                         : convolved(panorama, spectrum, {options.shape, alpha}, faceSize));
    }
    proceed(1.0);
    return chain;
}

std::optional<CubeMap> blurredCube(const Image& panorama, const Lobe& lobe, int faceSize,
                                   const Progress& progress) {
    const auto proceed = [&](float done) { return !progress || progress(done); };
    if (!proceed(0.0f)) return std::nullopt;
    const bool sharp = lobe.shape == LobeShape::ggx && lobe.alpha < kLeastSpectralAlpha;
    const Spectrum spectrum = spectrumOf(panorama, sharp ? 0 : lobeDegree(lobe));
    if (!proceed(0.5f)) return std::nullopt;
    CubeMap cube = convolved(panorama, spectrum, lobe, faceSize);
    if (!proceed(1.0f)) return std::nullopt;
    return cube;
}

CubeMap blurredBackdrop(const Image& panorama, float roughness) {
    const double alpha = static_cast<double>(roughness) * static_cast<double>(roughness);
    const int faceSize = alpha > 0.02 ? 256 : alpha > 0.01 ? 512 : 1024;
    CubeMap cube =
        *blurredCube(panorama, {LobeShape::ggx, std::max(alpha, kLeastBackdropAlpha)}, faceSize);
    if (alpha >= kLeastBackdropAlpha) return cube;
    const CubeMap sharp = cubeFromEquirect(panorama, faceSize);
    const auto share = static_cast<float>(alpha / kLeastBackdropAlpha);
    for (const CubeFace face : kCubeFaces) {
        const std::span<glm::vec3> texels = cube.texels(face);
        for (std::size_t i = 0; i < texels.size(); ++i)
            texels[i] = glm::mix(sharp.texels(face)[i], texels[i], share);
    }
    return cube;
}

}  // namespace tukor
