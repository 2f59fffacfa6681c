#include "tukor/environment/equirect_area.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "tukor/base/parallel.h"
#include "tukor/environment/cube_mips.h"
#include "tukor/environment/equirect_rows.h"
#include "tukor/environment/float4.h"

namespace tukor {

namespace {

constexpr float kPi = std::numbers::pi_v<float>;

Float4 pixelAt(const Image& panorama, std::size_t index) noexcept {
    const std::span<const glm::vec3> pixels = panorama.pixels();
    return index + 1 < pixels.size() ? loadFloat4(&pixels[index]) : float4(pixels[index]);
}

/// A span of longitudes within one column of texels and one column of pixels.
struct Strip {
    int texelColumn;
    int pixelColumn;
    float longitudes;  // width in radians
    float slope;       // 1 + s^2 at its middle
};

/// The strips of a face beside the horizon, from s = -1 to 1.
std::vector<Strip> stripsOf(CubeFace face, int faceSize, int width) {
    const glm::vec3 axis = directionFromCube({face, 0.0f, 0.0f});
    // Longitude runs against s on these faces: a cube map is seen from outside, a panorama from
    // inside.
    const double middle =
        std::atan2(static_cast<double>(axis.x), -static_cast<double>(axis.z)) + std::numbers::pi;
    const double scale = width / (2.0 * std::numbers::pi);
    std::vector<Strip> strips;
    for (int column = 0; column < faceSize; ++column) {
        const double last = std::atan((2.0 * column + 2.0 - faceSize) / faceSize);
        double begin = std::atan((2.0 * column - faceSize) / faceSize);
        while (begin < last) {
            const double pixel = (middle - begin) * scale;
            // Downwards to the next pixel edge; the margin keeps rounding from making empty strips.
            const double edge = std::ceil(pixel - 1e-7) - 1.0;
            const double end = std::min(last, middle - edge / scale);
            const double s = std::tan(0.5 * (begin + end));
            const int pixelColumn = static_cast<int>(edge) % width;
            strips.push_back({column, pixelColumn < 0 ? pixelColumn + width : pixelColumn,
                              static_cast<float>(end - begin), static_cast<float>(1.0 + s * s)});
            begin = end;
        }
    }
    return strips;
}

/// Along a strip, solid angle is the difference of heights y of unit directions, whatever the
/// longitude: rows of pixels and of texels are clipped against each other by their heights.
void fillSide(const Image& panorama, CubeMap& cube, CubeFace face) {
    const int size = cube.faceSize();
    const int height = panorama.height();
    const std::vector<Strip> strips = stripsOf(face, size, panorama.width());
    std::vector<float> edges(static_cast<std::size_t>(height) +
                             1);  // heights of the edges of pixel rows
    for (int row = 0; row <= height; ++row)
        edges[static_cast<std::size_t>(row)] =
            static_cast<float>(std::cos(std::numbers::pi * row / height));
    edges.back() = -2.0f;  // below everything, so that a walk ends there whatever the rounding

    constexpr int kBand = 16;
    parallelFor(0, size, kBand, [&](int begin, int end) {
        std::vector<float> above(strips.size()), below(strips.size());
        std::vector<int> rows(strips.size());
        std::vector<Float4> sums(static_cast<std::size_t>(size));
        std::vector<float> weights(static_cast<std::size_t>(size));
        const auto heights = [&](int line, std::vector<float>& out) {
            const float t = static_cast<float>(2 * line - size) / static_cast<float>(size);
            for (std::size_t i = 0; i < strips.size(); ++i)
                out[i] = -t / std::sqrt(strips[i].slope + t * t);
        };
        heights(begin, above);
        for (std::size_t i = 0; i < strips.size(); ++i)
            rows[i] =
                std::clamp(static_cast<int>(std::acos(above[i]) / kPi * static_cast<float>(height)),
                           0, height - 1);
        for (int row = begin; row < end; ++row) {
            heights(row + 1, below);
            std::fill(sums.begin(), sums.end(), Float4{});
            std::fill(weights.begin(), weights.end(), 0.0f);
            for (std::size_t i = 0; i < strips.size(); ++i) {
                const Strip& strip = strips[i];
                std::size_t pixelRow = static_cast<std::size_t>(rows[i]);
                std::size_t pixel = pixelRow * static_cast<std::size_t>(panorama.width()) +
                                    static_cast<std::size_t>(strip.pixelColumn);
                float top = above[i];
                Float4 sum{};
                for (;;) {
                    const float bottom = std::max(edges[pixelRow + 1], below[i]);
                    sum += (top - bottom) * pixelAt(panorama, pixel);
                    if (edges[pixelRow + 1] <= below[i]) break;
                    top = bottom;
                    ++pixelRow;
                    pixel += static_cast<std::size_t>(panorama.width());
                }
                rows[i] = static_cast<int>(pixelRow);
                const auto texel = static_cast<std::size_t>(strip.texelColumn);
                sums[texel] += strip.longitudes * sum;
                weights[texel] += strip.longitudes * (above[i] - below[i]);
            }
            glm::vec3* texels =
                &cube.texels(face)[static_cast<std::size_t>(row) * static_cast<std::size_t>(size)];
            for (std::size_t i = 0; i < weights.size(); ++i)
                texels[i] = vec3FromFloat4(sums[i] / weights[i]);
            std::swap(above, below);
        }
    });
}

/// The faces around the poles, where texels and pixels lie at all angles to each other.
void fillPoles(const Image& panorama, CubeMap& cube) {
    // A rank-1 lattice: no two points share a 32nd in either direction, and none is near another.
    constexpr int kPoints = 32, kGenerator = 19;
    const int size = cube.faceSize();
    const int half = (size + 1) / 2;
    const float step = 2.0f / static_cast<float>(size);
    const int width = panorama.width(), lastRow = panorama.height() - 1;
    const glm::vec3* const pixels = panorama.pixels().data();
    // A load reads 16 bytes of 12: what falls on the very last pixel is taken from the one before.
    const int lastPixel = static_cast<int>(panorama.pixels().size()) - 2;
    parallelFor(0, size, 16, [&](int begin, int end) {
        // (s, -t) on -Y lies right below (s, t) on +Y, and (-s, t) on the mirrored longitude: one
        // place serves four texels.
        EquirectRow places(width, lastRow + 1, half);
        struct Four {
            std::array<Float4, 4> sums;
        };
        std::vector<Four> texels(static_cast<std::size_t>(half));
        for (int row = begin; row < end; ++row) {
            std::fill(texels.begin(), texels.end(), Four{});
            for (int point = 0; point < kPoints; ++point) {
                const float s = (static_cast<float>(point) + 0.5f) / kPoints;
                const float t = (static_cast<float>(point * kGenerator % kPoints) + 0.5f) / kPoints;
                places.place(CubeFace::posY, (static_cast<float>(row) + t) * step - 1.0f,
                             s * step - 1.0f, step);
                for (std::size_t i = 0; i < texels.size(); ++i) {
                    const int x = std::min(static_cast<int>(places.columns[i]), width - 1);
                    const int y = std::min(static_cast<int>(places.rows[i]), lastRow);
                    const int up = y * width, down = (lastRow - y) * width;
                    auto& sums = texels[i].sums;
                    sums[0] += loadFloat4(pixels + std::min(up + x, lastPixel));
                    sums[1] += loadFloat4(pixels + std::min(up + width - 1 - x, lastPixel));
                    sums[2] += loadFloat4(pixels + std::min(down + x, lastPixel));
                    sums[3] += loadFloat4(pixels + std::min(down + width - 1 - x, lastPixel));
                }
            }
            const auto line = [&](CubeFace face, int at) {
                return cube.texels(face).subspan(static_cast<std::size_t>(at) *
                                                 static_cast<std::size_t>(size));
            };
            const auto posY = line(CubeFace::posY, row),
                       negY = line(CubeFace::negY, size - 1 - row);
            for (int i = 0; i < half; ++i) {
                const auto left = static_cast<std::size_t>(i);
                const auto right = static_cast<std::size_t>(size - 1 - i);
                const auto& sums = texels[left].sums;
                posY[left] = vec3FromFloat4(sums[0] / float{kPoints});
                negY[left] = vec3FromFloat4(sums[2] / float{kPoints});
                if (left == right) continue;  // its two halves are one column
                posY[right] = vec3FromFloat4(sums[1] / float{kPoints});
                negY[right] = vec3FromFloat4(sums[3] / float{kPoints});
            }
        }
    });
}

}  // namespace

CubeMap areaCubeFromEquirect(const Image& panorama, int faceSize) {
    // The samples at the poles suffice while a texel spans few pixels; from there on texels are
    // averaged.
    const float natural = static_cast<float>(panorama.width()) / kPi;
    const int factor =
        std::max(1, static_cast<int>(std::ceil(0.75f * natural / static_cast<float>(faceSize))));
    CubeMap cube(faceSize * factor);
    for (const CubeFace face : {CubeFace::posX, CubeFace::negX, CubeFace::posZ, CubeFace::negZ})
        fillSide(panorama, cube, face);
    fillPoles(panorama, cube);
    return factor == 1 ? cube : shrunkCube(cube, faceSize);
}

}  // namespace tukor
