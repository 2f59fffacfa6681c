#include "tukor/gl/environment_texture.h"

#include <algorithm>
#include <bit>

#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/base/parallel.h"
#include "tukor/environment/cube_mips.h"
#include "tukor/gl/half_float.h"

namespace tukor::gl {

namespace {

// Texels darker than 2^-24 of this many times the half range are lost: 6e-5 at most, below what
// eight bits show at any sensible exposure. Brighter suns than 1024 * 65504 are clipped.
constexpr float kLargestScale = 1024.0f;

float scaleFor(const CubeMap& cube) {
    float brightest = 0.0f;
    for (const CubeFace face : kCubeFaces)
        for (const glm::vec3& texel : cube.texels(face))
            brightest = std::max({brightest, texel.x, texel.y, texel.z});
    float scale = 1.0f;
    while (brightest > kLargestHalf * scale && scale < kLargestScale) scale *= 2.0f;
    return scale;
}

GLenum target(int face) {
    return GL_TEXTURE_CUBE_MAP_POSITIVE_X + static_cast<GLenum>(face);
}

void upload(int face, int level, const CubeMap& cube, float factor) {
    const int size = cube.faceSize();
    const std::span<const glm::vec3> texels =
        cube.texels(kCubeFaces[static_cast<std::size_t>(face)]);
    std::vector<std::uint64_t> halves(texels.size());
    parallelFor(0, size, 64, [&](int begin, int end) {
        const auto first = static_cast<std::size_t>(begin) * static_cast<std::size_t>(size);
        const auto last = static_cast<std::size_t>(end) * static_cast<std::size_t>(size);
        for (std::size_t i = first; i < last; ++i)
            halves[i] = halvesFromColour(glm::min(texels[i] * factor, glm::vec3(kLargestHalf)));
    });
    glTexSubImage2D(target(face), level, 0, 0, size, size, GL_RGBA, GL_HALF_FLOAT, halves.data());
}

}  // namespace

EnvironmentTexture::EnvironmentTexture(const CubeMap& cube)
    : texture_(Texture::make()), scale_(scaleFor(cube)), faceSize_(cube.faceSize()) {
    GLint largest = 0;
    glGetIntegerv(GL_MAX_CUBE_MAP_TEXTURE_SIZE, &largest);
    if (faceSize_ > largest)
        throw Error(fmt::format(
            "the environment has faces of {} texels; this OpenGL driver takes at most {}",
            faceSize_, largest));
    levels_ = static_cast<int>(std::bit_width(static_cast<unsigned>(faceSize_)));

    bind(0);
    glTexStorage2D(GL_TEXTURE_CUBE_MAP, levels_, GL_RGBA16F, faceSize_, faceSize_);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAX_LEVEL, 0);
    for (int face = 0; face < 6; ++face) upload(face, 0, cube, 1.0f / scale_);
}

void EnvironmentTexture::bind(int unit) const {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_CUBE_MAP, texture_.id());
}

void EnvironmentTexture::needLevels(const CubeMap& cube) {
    if (filled_) return;
    filled_ = true;
    const std::vector<CubeMap> mips = cubeMips(cube);
    bind(0);
    for (int level = 1; level < levels_; ++level) {
        const CubeMap& mip = mips[static_cast<std::size_t>(level - 1)];
        for (int face = 0; face < 6; ++face) upload(face, level, mip, 1.0f / scale_);
    }
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAX_LEVEL, levels_ - 1);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
}

}  // namespace tukor::gl
