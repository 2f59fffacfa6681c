#include "tukor/gl/finish_parts.h"

#include "tukor/environment/brdf_table.h"
#include "tukor/environment/panorama.h"
#include "tukor/environment/prefilter.h"
#include "tukor/gl/half_float.h"
#include "tukor/gl/shaders.h"

namespace tukor::gl {

namespace {

void appendHalves(std::vector<std::uint64_t>& halves, std::span<const glm::vec3> texels,
                  float factor) {
    for (const glm::vec3 texel : texels)
        halves.push_back(halvesFromColour(glm::min(texel * factor, glm::vec3(kLargestHalf))));
}

}  // namespace

FinishLight finishLight(const LightSource& source, float scale) {
    const ChainOptions options{
        .faceSize = kChainFaceSize, .levels = kChainLevels, .scale = RoughnessScale::linear};
    const PrefilteredChain chain =
        source.panorama ? prefilteredChain(*source.panorama, options)
                        : prefilteredChain(
                              panoramaFromCube(*source.cube, 4 * source.cube->faceSize()), options);
    FinishLight light;
    for (const CubeMap& cube : chain.levels)
        for (const CubeFace face : kCubeFaces)
            appendHalves(light.chain, cube.texels(face), 1.0f / scale);
    appendHalves(light.table, brdfNodeTable(kTableSize).pixels(), 1.0f);
    return light;
}

const ShaderSource& finishShader() {
    return shaders::finishFrag;
}

const ShaderSource& tracedFinishesShader() {
    return shaders::tracedFrag;
}

}  // namespace tukor::gl
