#include "tukor/gl/light_chain.h"

#include <algorithm>

#include "tukor/gl/table.h"

namespace tukor::gl {

namespace {

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

/// Fills a level of the cube map that is bound; where the next one's texels begin.
const std::uint64_t* uploadFaces(int level, int size, const std::uint64_t* texels) {
    for (GLenum face = 0; face < 6; ++face, texels += size * size)
        glTexSubImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, level, 0, 0, size, size, GL_RGBA,
                        GL_HALF_FLOAT, texels);
    return texels;
}

constexpr int kLitWidth = 128;  // texels a row, two a direction

}  // namespace

LightChain::LightChain(const Environment& environment, float scale)
    : source_{environment.panorama, nullptr}, scale_(scale) {
    if (source_.panorama && source_.panorama->empty()) source_.panorama = nullptr;
    if (!source_.panorama) source_.cube = std::make_shared<CubeMap>(environment.radiance);
}

void LightChain::bind(int unit) {
    bindTo(unit, GL_TEXTURE_CUBE_MAP, chain_);
    bindTo(unit + 1, GL_TEXTURE_2D, table_);
    if (ready()) return;
    const FinishLight light = finishLight(source_, scale_);
    table_ = Texture::make();
    bindTo(unit + 1, GL_TEXTURE_2D, table_);
    glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA16F, kTableSize, kTableSize);
    setFilters(GL_TEXTURE_2D, GL_LINEAR);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, kTableSize, kTableSize, GL_RGBA, GL_HALF_FLOAT,
                    light.table.data());
    chain_ = Texture::make();
    bindTo(unit, GL_TEXTURE_CUBE_MAP, chain_);
    glTexStorage2D(GL_TEXTURE_CUBE_MAP, kChainLevels, GL_RGBA16F, kChainFaceSize, kChainFaceSize);
    setFilters(GL_TEXTURE_CUBE_MAP, GL_LINEAR_MIPMAP_LINEAR);
    const std::uint64_t* texels = light.chain.data();
    for (int level = 0; level < kChainLevels; ++level)
        texels = uploadFaces(level, kChainFaceSize >> level, texels);
}

float LightChain::bindBlurred(int unit, float roughness) {
    if (backdropRoughness_ != roughness) {
        const BackdropLight light = backdropLight(source_, scale_, roughness);
        if (light.texels.empty()) {
            bind(unit);
            return roughness * (kChainLevels - 1);
        }
        backdropRoughness_ = roughness;
        backdrop_ = Texture::make();
        bindTo(unit, GL_TEXTURE_CUBE_MAP, backdrop_);
        glTexStorage2D(GL_TEXTURE_CUBE_MAP, 1, GL_RGBA16F, light.faceSize, light.faceSize);
        setFilters(GL_TEXTURE_CUBE_MAP, GL_LINEAR);
        uploadFaces(0, light.faceSize, light.texels.data());
    }
    bindTo(unit, GL_TEXTURE_CUBE_MAP, backdrop_);
    return 0.0f;
}

glm::vec3 LightChain::bindGround(int unit, std::span<const LitDirection> lamps) {
    if (ground_.id() == 0 ||
        !std::equal(lamps.begin(), lamps.end(), groundLamps_.begin(), groundLamps_.end())) {
        groundLamps_.assign(lamps.begin(), lamps.end());
        std::vector<glm::vec4> texels = groundLight(source_, scale_, lamps);
        texels.resize(2 * kLitDirections);
        groundIrradiance_ = glm::vec3(0.0f);
        for (std::size_t i = 1; i < texels.size(); i += 2)
            groundIrradiance_ += glm::vec3(texels[i]) / static_cast<float>(kLitDirections);
        ground_ = makeTable(GL_RGBA32F, GL_RGBA, GL_FLOAT, kLitWidth, texels.size(), texels.data());
    }
    bindTo(unit, GL_TEXTURE_2D, ground_);
    return groundIrradiance_;
}

}  // namespace tukor::gl
