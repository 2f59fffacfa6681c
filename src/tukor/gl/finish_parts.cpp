#include "tukor/gl/finish_parts.h"

#include "tukor/environment/brdf_table.h"
#include "tukor/environment/panorama.h"
#include "tukor/environment/prefilter.h"
#include "tukor/gl/half_float.h"
#include "tukor/gl/shaders.h"
#include "tukor/optics/spectrum.h"

namespace tukor::gl {

namespace {

void appendHalves(std::vector<std::uint64_t>& halves, std::span<const glm::vec3> texels,
                  float factor) {
    for (const glm::vec3 texel : texels)
        halves.push_back(halvesFromColour(glm::min(texel * factor, glm::vec3(kLargestHalf))));
}

void appendFaces(std::vector<std::uint64_t>& halves, const CubeMap& cube, float factor) {
    for (const CubeFace face : kCubeFaces) appendHalves(halves, cube.texels(face), factor);
}

/// The panorama, made from the cube map where there is none.
const Image& panoramaOf(LightSource& source) {
    if (source.panorama) return *source.panorama;
    if (!source.unrolled)
        source.unrolled =
            std::make_shared<Image>(panoramaFromCube(*source.cube, 4 * source.cube->faceSize()));
    return *source.unrolled;
}

}  // namespace

FinishLight finishLight(LightSource& source, float scale) {
    const ChainOptions options{
        .faceSize = kChainFaceSize, .levels = kChainLevels, .scale = RoughnessScale::linear};
    const PrefilteredChain chain = prefilteredChain(panoramaOf(source), options);
    FinishLight light;
    for (const CubeMap& cube : chain.levels) appendFaces(light.chain, cube, 1.0f / scale);
    appendHalves(light.table, brdfNodeTable(kTableSize).pixels(), 1.0f);
    return light;
}

BackdropLight backdropLight(LightSource& source, float scale, float roughness) {
    const CubeMap cube = blurredBackdrop(panoramaOf(source), roughness);
    BackdropLight light{cube.faceSize(), {}};
    appendFaces(light.texels, cube, 1.0f / scale);
    return light;
}

std::vector<glm::vec4> groundLight(const LightSource& source, float scale,
                                   std::span<const LitDirection> lamps) {
    std::vector<glm::vec4> texels;
    for (const LitDirection& one : source.panorama
                                       ? litDirections(*source.panorama, lamps, kLitDirections)
                                       : litDirections(*source.cube, lamps, kLitDirections)) {
        texels.emplace_back(one.direction, 0.0f);
        texels.emplace_back(one.irradiance * (kLitDirections / scale), 0.0f);
    }
    return texels;
}

std::vector<glm::vec4> spectrumTable() {
    std::vector<glm::vec4> table;
    for (const optics::Wavelength& w : optics::visibleSpectrum())
        table.emplace_back(w.nm, w.weight);
    return table;
}

bool partsAtHand() noexcept {
    return true;
}

const ShaderSource& finishShader() {
    return shaders::finishFrag;
}

const ShaderSource& wholeTracedShader() {
    return shaders::tracedFrag;
}

}  // namespace tukor::gl
