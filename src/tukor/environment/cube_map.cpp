#include "tukor/environment/cube_map.h"

#include <algorithm>
#include <cmath>

#include "tukor/base/error.h"
#include "tukor/environment/cube_texel.h"

namespace tukor {

namespace {

/// Columns: s, t and the outward axis of each face. The table of cube_map.h.
constexpr std::array<std::array<glm::ivec3, 3>, 6> kAxes = {{
    {{{0, 0, -1}, {0, -1, 0}, {1, 0, 0}}},
    {{{0, 0, 1}, {0, -1, 0}, {-1, 0, 0}}},
    {{{1, 0, 0}, {0, 0, 1}, {0, 1, 0}}},
    {{{1, 0, 0}, {0, 0, -1}, {0, -1, 0}}},
    {{{1, 0, 0}, {0, -1, 0}, {0, 0, 1}}},
    {{{-1, 0, 0}, {0, -1, 0}, {0, 0, -1}}},
}};

int dot(glm::ivec3 a, glm::ivec3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// Integral over the sphere of the rectangle from the face's centre to (s, t), face at distance 1.
double cornerSolidAngle(double s, double t) {
    return std::atan2(s * t, std::sqrt(s * s + t * t + 1.0));
}

std::size_t texelIndex(int faceSize, int column, int row) {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(faceSize) +
           static_cast<std::size_t>(column);
}

}  // namespace

CubeMap::CubeMap(int faceSize)
    : faceSize_(faceSize),
      texels_(6 * static_cast<std::size_t>(faceSize) * static_cast<std::size_t>(faceSize),
              glm::vec3(0.0f)) {
    TUKOR_ASSERT(faceSize >= 1);
}

std::span<const glm::vec3> CubeMap::texels(CubeFace face) const noexcept {
    const std::size_t count = texels_.size() / 6;
    return std::span(texels_).subspan(static_cast<std::size_t>(face) * count, count);
}

std::span<glm::vec3> CubeMap::texels(CubeFace face) noexcept {
    const std::size_t count = texels_.size() / 6;
    return std::span(texels_).subspan(static_cast<std::size_t>(face) * count, count);
}

glm::vec3 CubeMap::radiance(glm::vec3 direction) const noexcept {
    const CubePoint point = cubeFromDirection(direction);
    const auto size = static_cast<float>(faceSize_);
    // In this order of arguments a NaN becomes the lower bound: no direction reads out of bounds.
    const float u = std::min(std::max(-0.5f, 0.5f * (point.s + 1.0f) * size - 0.5f), size - 0.5f);
    const float v = std::min(std::max(-0.5f, 0.5f * (point.t + 1.0f) * size - 0.5f), size - 0.5f);
    const int column = static_cast<int>(u + 1.0f) - 1;
    const int row = static_cast<int>(v + 1.0f) - 1;
    const float right = u - static_cast<float>(column);
    const float down = v - static_cast<float>(row);

    const std::span<const glm::vec3> face = texels(point.face);
    if (column >= 0 && row >= 0 && column + 1 < faceSize_ && row + 1 < faceSize_) {
        const glm::vec3* above = &face[texelIndex(faceSize_, column, row)];
        const glm::vec3* below = above + faceSize_;
        return (1.0f - down) * ((1.0f - right) * above[0] + right * above[1]) +
               down * ((1.0f - right) * below[0] + right * below[1]);
    }

    glm::vec3 sum(0.0f);
    glm::vec3 others(0.0f);  // of the three texels, where one is missing
    float missing = 0.0f;    // weight of the texel that does not exist at a corner of the cube
    for (int i = 0; i < 4; ++i) {
        const CubeTexel texel{point.face, column + i % 2, row + i / 2};
        const float weight = (i % 2 ? right : 1.0f - right) * (i / 2 ? down : 1.0f - down);
        const bool columnOutside = texel.column < 0 || texel.column >= faceSize_;
        const bool rowOutside = texel.row < 0 || texel.row >= faceSize_;
        if (columnOutside && rowOutside) {
            missing += weight;
            continue;
        }
        const CubeTexel real = texelAcrossEdge(texel, faceSize_);
        const glm::vec3 value = texels(real.face)[texelIndex(faceSize_, real.column, real.row)];
        sum += weight * value;
        others += value;
    }
    // GLES 3.0, section 3.8.10: the mean of the three texels stands for the fourth.
    return sum + missing / 3.0f * others;
}

glm::vec3 directionFromCube(CubePoint point) noexcept {
    const auto& [s, t, axis] = kAxes[static_cast<std::size_t>(point.face)];
    return glm::vec3(axis) + point.s * glm::vec3(s) + point.t * glm::vec3(t);
}

glm::vec3 directionFromTexel(CubeTexel texel, int faceSize) noexcept {
    const float scale = 1.0f / static_cast<float>(faceSize);
    return directionFromCube({texel.face,
                              static_cast<float>(2 * texel.column + 1 - faceSize) * scale,
                              static_cast<float>(2 * texel.row + 1 - faceSize) * scale});
}

CubeTexel texelAcrossEdge(CubeTexel texel, int faceSize) noexcept {
    // In half texels the face spans [-faceSize, faceSize] at height faceSize above the centre.
    // What lies beyond an edge by some length lies on the neighbour that much below the edge.
    int s = 2 * texel.column + 1 - faceSize;
    int t = 2 * texel.row + 1 - faceSize;
    int height = faceSize;
    const int overS = std::abs(s) - faceSize;
    const int overT = std::abs(t) - faceSize;
    if (overS <= 0 && overT <= 0) return texel;
    TUKOR_ASSERT(overS <= 0 || overT <= 0);
    if (overS > 0) {
        height -= overS;
        s = s > 0 ? faceSize : -faceSize;
    } else {
        height -= overT;
        t = t > 0 ? faceSize : -faceSize;
    }
    const auto& own = kAxes[static_cast<std::size_t>(texel.face)];
    const glm::ivec3 place = s * own[0] + t * own[1] + height * own[2];
    for (const CubeFace face : kCubeFaces) {
        const auto& axes = kAxes[static_cast<std::size_t>(face)];
        if (dot(place, axes[2]) == faceSize)
            return {face, (dot(place, axes[0]) + faceSize - 1) / 2,
                    (dot(place, axes[1]) + faceSize - 1) / 2};
    }
    return texel;
}

double texelSolidAngle(int faceSize, int column, int row) noexcept {
    const double scale = 1.0 / faceSize;
    const double s0 = (2 * column - faceSize) * scale, s1 = (2 * column + 2 - faceSize) * scale;
    const double t0 = (2 * row - faceSize) * scale, t1 = (2 * row + 2 - faceSize) * scale;
    return cornerSolidAngle(s1, t1) - cornerSolidAngle(s0, t1) - cornerSolidAngle(s1, t0) +
           cornerSolidAngle(s0, t0);
}

std::vector<float> faceSolidAngles(int faceSize) {
    std::vector<float> angles(static_cast<std::size_t>(faceSize) *
                              static_cast<std::size_t>(faceSize));
    const double scale = 1.0 / faceSize;
    const auto at = [&](int line) { return (2 * line - faceSize) * scale; };
    // One quarter, mirrored into the other three; each corner is computed once.
    const int half = (faceSize + 1) / 2;
    std::vector<double> above(static_cast<std::size_t>(half) + 1);
    std::vector<double> below(above.size());
    for (int i = 0; i <= half; ++i)
        above[static_cast<std::size_t>(i)] = cornerSolidAngle(at(i), at(0));
    for (int row = 0; row < half; ++row) {
        for (int i = 0; i <= half; ++i)
            below[static_cast<std::size_t>(i)] = cornerSolidAngle(at(i), at(row + 1));
        for (int column = 0; column < half; ++column) {
            const auto i = static_cast<std::size_t>(column);
            const auto angle =
                static_cast<float>(below[i + 1] - below[i] - above[i + 1] + above[i]);
            const int mirroredColumn = faceSize - 1 - column, mirroredRow = faceSize - 1 - row;
            angles[texelIndex(faceSize, column, row)] = angle;
            angles[texelIndex(faceSize, mirroredColumn, row)] = angle;
            angles[texelIndex(faceSize, column, mirroredRow)] = angle;
            angles[texelIndex(faceSize, mirroredColumn, mirroredRow)] = angle;
        }
        std::swap(above, below);
    }
    return angles;
}

}  // namespace tukor
