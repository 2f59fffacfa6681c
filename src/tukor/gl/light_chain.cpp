#include "tukor/gl/light_chain.h"

#include <algorithm>
#include <vector>

#include "tukor/environment/brdf_table.h"
#include "tukor/environment/panorama.h"
#include "tukor/environment/prefilter.h"
#include "tukor/gl/half_float.h"

namespace tukor::gl {

namespace {

constexpr int kFaceSize = 256;  // of level 0, which is not used where the environment itself serves
constexpr int kTableSize = 32;

std::vector<std::uint64_t> halvesOf(std::span<const glm::vec3> texels, float factor) {
    std::vector<std::uint64_t> halves;
    halves.reserve(texels.size());
    for (const glm::vec3 texel : texels)
        halves.push_back(halvesFromColour(glm::min(texel * factor, glm::vec3(kLargestHalf))));
    return halves;
}

void setFilters(GLenum target, GLenum minify) {
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, static_cast<GLint>(minify));
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(target, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(target, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

void bindTo(int unit, GLenum target, const Texture& texture) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(target, texture.id());
}

}  // namespace

LightChain::LightChain(const Environment& environment, float scale)
    : panorama_(environment.panorama), scale_(scale) {
    if (!panorama_ || panorama_->empty())
        panorama_ = std::make_shared<Image>(
            panoramaFromCube(environment.radiance, 4 * environment.radiance.faceSize()));
}

void LightChain::bind(int unit) {
    bindTo(unit, GL_TEXTURE_CUBE_MAP, chain_);
    if (chain_.id() == 0) {
        const PrefilteredChain chain = prefilteredChain(
            *panorama_,
            {.faceSize = kFaceSize, .levels = kChainLevels, .scale = RoughnessScale::linear});
        chain_ = Texture::make();
        bindTo(unit, GL_TEXTURE_CUBE_MAP, chain_);
        glTexStorage2D(GL_TEXTURE_CUBE_MAP, kChainLevels, GL_RGBA16F, kFaceSize, kFaceSize);
        setFilters(GL_TEXTURE_CUBE_MAP, GL_LINEAR_MIPMAP_LINEAR);
        for (int level = 0; level < kChainLevels; ++level) {
            const CubeMap& cube = chain.levels[static_cast<std::size_t>(level)];
            for (GLenum face = 0; face < 6; ++face)
                glTexSubImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, level, 0, 0, cube.faceSize(),
                                cube.faceSize(), GL_RGBA, GL_HALF_FLOAT,
                                halvesOf(cube.texels(kCubeFaces[face]), 1.0f / scale_).data());
        }
    }
    bindTo(unit + 1, GL_TEXTURE_2D, table_);
    if (table_.id() == 0) {
        const Image table = brdfNodeTable(kTableSize);
        table_ = Texture::make();
        bindTo(unit + 1, GL_TEXTURE_2D, table_);
        glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA16F, kTableSize, kTableSize);
        setFilters(GL_TEXTURE_2D, GL_LINEAR);
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, kTableSize, kTableSize, GL_RGBA, GL_HALF_FLOAT,
                        halvesOf(table.pixels(), 1.0f).data());
    }
}

}  // namespace tukor::gl
