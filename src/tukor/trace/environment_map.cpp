#include "tukor/trace/environment_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tukor/base/parallel.h"
#include "tukor/environment/cube_mips.h"
#include "tukor/environment/cube_texel.h"
#include "tukor/transport/footprint.h"
#include "tukor/transport/look_ups.h"

namespace tukor::trace {

namespace {

// Footprints are clamped to 16 texels (transport/footprint.h): no more levels are ever read.
constexpr std::size_t kLevels = 5;

constexpr float kPi = std::numbers::pi_v<float>;

EnvironmentMap::Texel texelOf(glm::vec3 radiance) {
    return {radiance.x, radiance.y, radiance.z, 0.0f};
}

/// atan2 to 2e-7, a third of the library's time: minimax on [0, 1] and reflections.
float quickAtan2(float y, float x) {
    const float ax = std::abs(x), ay = std::abs(y);
    const float most = std::max(ax, ay), least = std::min(ax, ay);
    const float t = most > 0.0f ? least / most : 0.0f;
    const float s = t * t;
    float a = 0.00282363896258175373f;
    a = a * s - 0.0159569028764963150f;
    a = a * s + 0.0425049886107444763f;
    a = a * s - 0.0748900920152664185f;
    a = a * s + 0.106347933411598206f;
    a = a * s - 0.142027363181114197f;
    a = a * s + 0.199926957488059998f;
    a = a * s - 0.333331018686294556f;
    a = a * s * t + t;
    a = ay > ax ? 0.5f * kPi - a : a;
    a = x < 0.0f ? kPi - a : a;
    return y < 0.0f ? -a : a;
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
    for (int size = cube.faceSize() / 2; size >= 1 && levels_.size() < kLevels; size /= 2) {
        coarser = shrunkCube(levels_.size() == 1 ? cube : coarser, size);
        addCubeLevel(coarser, intensity);
    }
}

EnvironmentMap::EnvironmentMap(const Image& panorama, float rotation, float intensity)
    : EnvironmentMap(Form::panorama, rotation) {
    int width = panorama.width(), height = panorama.height();
    // At the horizon a pixel spans 2 pi / width, a cube's texel on average sqrt(4 pi / 6) / size.
    equivalentFaceSize_ = std::max(1, static_cast<int>(0.2303f * static_cast<float>(width)));
    addPanoramaLevel(panorama.pixels(), width, height, intensity);
    std::vector<glm::vec3> pixels;
    while (levels_.size() < kLevels && width >= 8 && height >= 4) {
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

EnvironmentMap::Place EnvironmentMap::placeOf(glm::vec3 direction) const noexcept {
    if (form_ == Form::cube) {
        const CubePoint point = cubeFromDirection(direction);
        return {static_cast<std::size_t>(point.face), 0.5f * (point.s + 1.0f),
                0.5f * (point.t + 1.0f)};
    }
    const float across = std::sqrt(direction.x * direction.x + direction.z * direction.z);
    return {0, 0.5f + quickAtan2(direction.x, -direction.z) * (0.5f / kPi),
            quickAtan2(across, direction.y) * (1.0f / kPi)};
}

EnvironmentMap::Texel EnvironmentMap::bilinear(const Level& level,
                                               const Place& place) const noexcept {
    const auto w = static_cast<float>(level.width), h = static_cast<float>(level.height);
    // Borders shift all texels by one. Clamped so that not even a NaN reads out of bounds.
    const float u = std::min(std::max(0.0f, place.x * w + 0.5f), w + 0.5f);
    const float v = std::min(std::max(0.0f, place.y * h + 0.5f), h + 0.5f);
    const int column = std::min(static_cast<int>(u), level.width);
    const int row = std::min(static_cast<int>(v), level.height);
    const float right = u - static_cast<float>(column);
    const float down = v - static_cast<float>(row);
    const auto stride = static_cast<std::size_t>(level.width) + 2;
    const std::size_t line =
        place.panel * (static_cast<std::size_t>(level.height) + 2) + static_cast<std::size_t>(row);
    const Texel* above = level.texels.get() + line * stride + static_cast<std::size_t>(column);
    const Texel* below = above + stride;
    const float w00 = (1.0f - right) * (1.0f - down), w10 = right * (1.0f - down);
    const float w01 = (1.0f - right) * down, w11 = right * down;
    Texel sum;  // of all four floats: the compiler takes them at once
    sum.r = w00 * above[0].r + w10 * above[1].r + w01 * below[0].r + w11 * below[1].r;
    sum.g = w00 * above[0].g + w10 * above[1].g + w01 * below[0].g + w11 * below[1].g;
    sum.b = w00 * above[0].b + w10 * above[1].b + w01 * below[0].b + w11 * below[1].b;
    sum.unused = w00 * above[0].unused + w10 * above[1].unused + w01 * below[0].unused +
                 w11 * below[1].unused;
    return sum;
}

glm::vec3 EnvironmentMap::turned(glm::vec3 d) const noexcept {
    return {cosRotation_ * d.x - sinRotation_ * d.z, d.y, sinRotation_ * d.x + cosRotation_ * d.z};
}

glm::vec3 EnvironmentMap::look(glm::vec3 direction, float level) const noexcept {
    const Place place = placeOf(direction);
    const auto finest = std::min(static_cast<std::size_t>(level), levels_.size() - 1);
    const float between = level - static_cast<float>(finest);
    const Texel a = bilinear(levels_[finest], place);
    if (!(between > 0.0f) || finest + 1 == levels_.size()) return {a.r, a.g, a.b};
    const Texel b = bilinear(levels_[finest + 1], place);
    return {a.r + between * (b.r - a.r), a.g + between * (b.g - a.g), a.b + between * (b.b - a.b)};
}

glm::vec3 EnvironmentMap::radiance(glm::vec3 direction, float solidAngle) const noexcept {
    return look(turned(direction), transport::footprintLevel(solidAngle, equivalentFaceSize_));
}

glm::vec3 EnvironmentMap::radiance(glm::vec3 direction, glm::vec3 dx, glm::vec3 dy,
                                   int mostLookUps) const noexcept {
    const float texelsPerRadian = 0.691f * static_cast<float>(equivalentFaceSize_);
    const transport::LookUps l = transport::lookUpsOver(dx, dy, texelsPerRadian, mostLookUps);
    const float level = std::min(l.level, static_cast<float>(kLevels - 1));
    if (l.across * l.down == 1) return look(turned(direction), level);
    const glm::vec3 stepX = turned(l.stepX), stepY = turned(l.stepY);
    const glm::vec3 first = turned(direction + l.first);
    glm::vec3 sum(0.0f);
    for (int j = 0; j < l.down; ++j) {
        glm::vec3 at = first + static_cast<float>(j) * stepY;
        for (int i = 0; i < l.across; ++i, at += stepX) sum += look(at, level);
    }
    return sum / static_cast<float>(l.across * l.down);
}

}  // namespace tukor::trace
