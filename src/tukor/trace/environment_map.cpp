#include "tukor/trace/environment_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tukor/base/parallel.h"
#include "tukor/environment/cube_mips.h"
#include "tukor/environment/cube_texel.h"
#include "tukor/transport/look_ups.h"

namespace tukor::trace {

namespace {

constexpr float kPi = std::numbers::pi_v<float>;

EnvironmentMap::Texel texelOf(glm::vec3 radiance) {
    return {radiance.x, radiance.y, radiance.z, 0.0f};
}

/// Half the size, each pixel the mean over its solid angle; odd last rows and columns are left out.
std::vector<glm::vec3> halved(std::span<const glm::vec3> pixels, int width, int height) {
    const int w = width / 2, h = height / 2;
    std::vector<glm::vec3> half(static_cast<std::size_t>(w) * static_cast<std::size_t>(h));
    parallelFor(0, h, 32, [&](int begin, int end) {
        for (int row = begin; row < end; ++row) {
            const auto weight = [&](int r) {
                return std::sin(kPi * (static_cast<float>(r) + 0.5f) / static_cast<float>(height));
            };
            const float above = weight(2 * row) / (weight(2 * row) + weight(2 * row + 1));
            const glm::vec3* a = &pixels[static_cast<std::size_t>(2 * row) * width];
            const glm::vec3* b = a + width;
            glm::vec3* out = &half[static_cast<std::size_t>(row) * w];
            for (int i = 0; i < w; ++i) {
                out[i] = 0.5f * (above * (a[2 * i] + a[2 * i + 1]) +
                                 (1.0f - above) * (b[2 * i] + b[2 * i + 1]));
            }
        }
    });
    return half;
}

}  // namespace

EnvironmentMap::EnvironmentMap(Form form, float rotation)
    : form_(form), cosRotation_(std::cos(rotation)), sinRotation_(std::sin(rotation)) {}

EnvironmentMap::EnvironmentMap(const CubeMap& cube, float rotation, float intensity)
    : EnvironmentMap(Form::cube, rotation) {
    equivalentFaceSize_ = cube.faceSize();
    addCubeLevel(cube, intensity);
    CubeMap coarser(1);
    for (int size = cube.faceSize() / 2; size >= 1 && levels_.size() < kEnvironmentLevels;
         size /= 2) {
        coarser = shrunkCube(levels_.size() == 1 ? cube : coarser, size);
        addCubeLevel(coarser, intensity);
    }
}

EnvironmentMap::EnvironmentMap(const Image& panorama, float rotation, float intensity)
    : EnvironmentMap(Form::panorama, rotation) {
    int width = panorama.width(), height = panorama.height();
    // At the horizon a pixel spans 2 pi / width, a cube's texel on average sqrt(4 pi / 6) / size.
    equivalentFaceSize_ =
        std::max(1, static_cast<int>(transport::kFaceOfPanorama * static_cast<float>(width)));
    addPanoramaLevel(panorama.pixels(), width, height, intensity);
    std::vector<glm::vec3> pixels;
    while (levels_.size() < kEnvironmentLevels && width >= 8 && height >= 4) {
        pixels = halved(pixels.empty() ? panorama.pixels() : std::span<const glm::vec3>(pixels),
                        width, height);
        width /= 2;
        height /= 2;
        addPanoramaLevel(pixels, width, height, intensity);
    }
}

EnvironmentMap::Texel* EnvironmentMap::addLevel(int width, int height, int panels) {
    const std::size_t count = static_cast<std::size_t>(panels) *
                              (static_cast<std::size_t>(width) + 2) *
                              (static_cast<std::size_t>(height) + 2);
    levels_.push_back({width, height, std::make_unique_for_overwrite<Texel[]>(count)});
    return levels_.back().texels.get();
}

void EnvironmentMap::addPanoramaLevel(std::span<const glm::vec3> pixels, int width, int height,
                                      float intensity) {
    const std::size_t stride = static_cast<std::size_t>(width) + 2;
    Texel* const texels = addLevel(width, height, 1);
    parallelFor(-1, height + 1, 64, [&](int begin, int end) {
        for (int row = begin; row < end; ++row) {
            // Over a pole lies the same row, half way round.
            const int real = std::clamp(row, 0, height - 1);
            const int turn = row == real ? 0 : width / 2;
            Texel* out = texels + static_cast<std::size_t>(row + 1) * stride;
            const glm::vec3* line = &pixels[static_cast<std::size_t>(real) * width];
            int c = (width - 1 + turn) % width;
            for (int column = -1; column <= width; ++column, ++out) {
                *out = texelOf(intensity * line[c]);
                if (++c == width) c = 0;
            }
        }
    });
}

void EnvironmentMap::addCubeLevel(const CubeMap& cube, float intensity) {
    const int size = cube.faceSize();
    const auto stride = static_cast<std::size_t>(size) + 2;
    Texel* const texels = addLevel(size, size, 6);
    const auto at = [&](CubeTexel t) {
        return intensity * cube.texels(t.face)[static_cast<std::size_t>(t.row) * size +
                                               static_cast<std::size_t>(t.column)];
    };
    parallelFor(0, 6 * (size + 2), 64, [&](int begin, int end) {
        for (int line = begin; line < end; ++line) {
            const CubeFace face = kCubeFaces[static_cast<std::size_t>(line / (size + 2))];
            const int row = line % (size + 2) - 1;
            const int r = std::clamp(row, 0, size - 1);
            Texel* out = texels + static_cast<std::size_t>(line) * stride;
            for (int column = -1; column <= size; ++column, ++out) {
                const int c = std::clamp(column, 0, size - 1);
                if (r == row && c == column) {
                    const glm::vec3* inner = &cube.texels(face)[static_cast<std::size_t>(r) * size];
                    for (; column < size; ++column) *out++ = texelOf(intensity * inner[column]);
                    --column;
                    --out;
                } else if (r == row || c == column) {
                    *out = texelOf(at(texelAcrossEdge({face, column, row}, size)));
                } else {
                    // Three texels meet at a corner of the cube: their mean stands for the fourth.
                    *out =
                        texelOf((at({face, c, r}) + at(texelAcrossEdge({face, column, r}, size)) +
                                 at(texelAcrossEdge({face, c, row}, size))) /
                                3.0f);
                }
            }
        }
    });
}

}  // namespace tukor::trace
