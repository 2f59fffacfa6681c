#include "tukor/gl/environment_texture.h"

#include <algorithm>
#include <bit>

#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/base/parallel.h"
#include "tukor/environment/cube_mips.h"
#include "tukor/gl/half_float.h"
#include "tukor/transport/look_ups.h"

namespace tukor::gl {

namespace {

// Texels darker than 2^-24 of this many times the half range are lost: 6e-5 at most, below what
// eight bits show at any sensible exposure. Brighter suns than 1024 * 65504 are clipped.
constexpr float kLargestScale = 1024.0f;

float brightestOf(std::span<const glm::vec3> texels) {
    glm::vec3 brightest(0.0f);
    for (const glm::vec3& texel : texels) brightest = glm::max(brightest, texel);
    return std::max({brightest.x, brightest.y, brightest.z});
}

float scaleFor(float brightest) {
    float scale = 1.0f;
    while (brightest > kLargestHalf * scale && scale < kLargestScale) scale *= 2.0f;
    return scale;
}

std::vector<std::uint64_t> halvesOf(std::span<const glm::vec3> texels, float factor) {
    std::vector<std::uint64_t> halves(texels.size());
    parallelFor(0, static_cast<int>((texels.size() + 4095) / 4096), 8, [&](int begin, int end) {
        const std::size_t last = std::min(texels.size(), static_cast<std::size_t>(end) * 4096);
        for (std::size_t i = static_cast<std::size_t>(begin) * 4096; i < last; ++i)
            halves[i] = halvesFromColour(glm::min(texels[i] * factor, glm::vec3(kLargestHalf)));
    });
    return halves;
}

// Larger ones take 1 GB of memory: then the cube map of the environment's own choice serves.
constexpr int kLargestPanorama = 8192;

GLenum target(int face) {
    return GL_TEXTURE_CUBE_MAP_POSITIVE_X + static_cast<GLenum>(face);
}

void uploadFace(int face, int level, const CubeMap& cube, float factor) {
    const std::span<const glm::vec3> texels =
        cube.texels(kCubeFaces[static_cast<std::size_t>(face)]);
    glTexSubImage2D(target(face), level, 0, 0, cube.faceSize(), cube.faceSize(), GL_RGBA,
                    GL_HALF_FLOAT, halvesOf(texels, factor).data());
}

int levelsFor(int size, Preparation preparation) {
    return preparation == Preparation::all
               ? static_cast<int>(std::bit_width(static_cast<unsigned>(size)))
               : 1;
}

void setFilters(GLenum kind, int levels, GLenum wrapS) {
    glTexParameteri(kind, GL_TEXTURE_MIN_FILTER, levels > 1 ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR);
    glTexParameteri(kind, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(kind, GL_TEXTURE_WRAP_S, static_cast<GLint>(wrapS));
    glTexParameteri(kind, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

}  // namespace

EnvironmentTexture::EnvironmentTexture(const Environment& environment, Preparation preparation)
    : texture_(Texture::make()) {
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    const Image* panorama = environment.panorama.get();
    panorama_ =
        panorama != nullptr && !panorama->empty() &&
        std::max(panorama->width(), panorama->height()) <= std::min(largest, kLargestPanorama);
    if (panorama_)
        uploadPanorama(*panorama, preparation);
    else
        uploadCube(environment.radiance, preparation);
}

void EnvironmentTexture::uploadPanorama(const Image& panorama, Preparation preparation) {
    const int width = panorama.width();
    const int height = panorama.height();
    // At the horizon a pixel spans 2 pi / width, a cube's texel on average sqrt(4 pi / 6) / size.
    faceSize_ =
        std::max(1, static_cast<int>(transport::kFaceOfPanorama * static_cast<float>(width)));
    scale_ = scaleFor(brightestOf(panorama.pixels()));
    const int levels = levelsFor(std::max(width, height), preparation);
    bind(0);
    glTexStorage2D(GL_TEXTURE_2D, levels, GL_RGBA16F, width, height);
    setFilters(GL_TEXTURE_2D, levels, GL_REPEAT);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, GL_RGBA, GL_HALF_FLOAT,
                    halvesOf(panorama.pixels(), 1.0f / scale_).data());
    if (levels > 1) glGenerateMipmap(GL_TEXTURE_2D);
}

void EnvironmentTexture::uploadCube(const CubeMap& cube, Preparation preparation) {
    faceSize_ = cube.faceSize();
    GLint largest = 0;
    glGetIntegerv(GL_MAX_CUBE_MAP_TEXTURE_SIZE, &largest);
    if (faceSize_ > largest)
        throw Error(fmt::format(
            "the environment has faces of {} texels; this OpenGL driver takes at most {}",
            faceSize_, largest));
    float brightest = 0.0f;
    for (const CubeFace face : kCubeFaces)
        brightest = std::max(brightest, brightestOf(cube.texels(face)));
    scale_ = scaleFor(brightest);
    const int levels = levelsFor(faceSize_, preparation);
    bind(0);
    glTexStorage2D(GL_TEXTURE_CUBE_MAP, levels, GL_RGBA16F, faceSize_, faceSize_);
    setFilters(GL_TEXTURE_CUBE_MAP, levels, GL_CLAMP_TO_EDGE);
    for (int face = 0; face < 6; ++face) uploadFace(face, 0, cube, 1.0f / scale_);
    if (levels == 1) return;
    const std::vector<CubeMap> mips = cubeMips(cube);
    for (int level = 1; level < levels; ++level)
        for (int face = 0; face < 6; ++face)
            uploadFace(face, level, mips[static_cast<std::size_t>(level - 1)], 1.0f / scale_);
}

void EnvironmentTexture::bind(int unit) const {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(panorama_ ? GL_TEXTURE_2D : GL_TEXTURE_CUBE_MAP, texture_.id());
}

}  // namespace tukor::gl
