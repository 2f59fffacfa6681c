// A cube map from a function of direction, with texels that average over their area where it
// matters.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "tukor/base/parallel.h"
#include "tukor/environment/cube_map.h"
#include "tukor/environment/grid_point.h"

namespace tukor {

/// Directions within an angle of an axis: what a piece of a face sees. Both are unit and cosine.
struct Cone {
    glm::vec3 axis;
    float cosine;
};

/// What `radiance` shows in all `directions`: it is a function of one, or of many that writes what
/// each shows, as this one does.
template <class Radiance>
void radianceAlong(const Radiance& radiance, std::span<const glm::vec3> directions,
                   glm::vec3* shown) {
    if constexpr (requires { radiance(directions, shown); }) {
        radiance(directions, shown);
    } else {
        for (const glm::vec3& direction : directions) *shown++ = radiance(direction);
    }
}

/// Fills a cube map with radiance by direction. `radianceIn(cone)` returns the function to call
/// with unit directions within that cone, as radianceAlong takes it, so that it can leave out what
/// the cone cannot see; both are called from several threads.
///
/// A texel whose centre differs from a neighbour's by more than 5 % is the mean of 6 x 6 samples;
/// others are smooth enough for one. Features thinner than a texel may be missed.
template <class RadianceIn>
[[nodiscard]] CubeMap cubeFromFunction(int faceSize, const RadianceIn& radianceIn) {
    CubeMap cube(faceSize);
    constexpr int kTile = 32;  // texels squared a piece: its border costs 13 %
    constexpr int kSamples = 6;
    constexpr int kStride = kTile + 2;
    const int tiles = (faceSize + kTile - 1) / kTile;  // along an edge
    const float step = 2.0f / static_cast<float>(faceSize);
    parallelFor(0, 6 * tiles * tiles, 16, [&](int begin, int end) {
        std::array<glm::vec3, kStride * kStride> centres;
        std::array<glm::vec3, std::max(kStride, kSamples * kSamples)> directions, shown;
        std::array<glm::vec3, kTile> excess;
        for (int tile = begin; tile < end; ++tile) {
            const auto face = static_cast<CubeFace>(tile / (tiles * tiles));
            const int firstRow = tile / tiles % tiles * kTile;
            const int firstColumn = tile % tiles * kTile;
            const int rows = std::min(kTile, faceSize - firstRow);
            const int columns = std::min(kTile, faceSize - firstColumn);
            const glm::vec3 axis = directionFromCube({face, 0.0f, 0.0f});
            const glm::vec3 across = directionFromCube({face, 1.0f, 0.0f}) - axis;
            const glm::vec3 down = directionFromCube({face, 0.0f, 1.0f}) - axis;
            const auto direction = [&](float column, float row) {
                const float s = (static_cast<float>(firstColumn) + column) * step - 1.0f;
                const float t = (static_cast<float>(firstRow) + row) * step - 1.0f;
                // |axis + s across + t down| without its sum: the three are orthonormal.
                return (axis + s * across + t * down) * (1.0f / std::sqrt(1.0f + s * s + t * t));
            };

            Cone cone{
                direction(0.5f * static_cast<float>(columns), 0.5f * static_cast<float>(rows)),
                1.0f};
            for (const float row : {-1.0f, static_cast<float>(rows + 1)})
                for (const float column : {-1.0f, static_cast<float>(columns + 1)})
                    cone.cosine =
                        std::min(cone.cosine, glm::dot(cone.axis, direction(column, row)));
            const auto radiance = radianceIn(cone);

            for (int row = -1; row <= rows; ++row) {
                for (int i = 0; i < columns + 2; ++i)
                    directions[static_cast<std::size_t>(i)] =
                        direction(static_cast<float>(i) - 0.5f, static_cast<float>(row) + 0.5f);
                radianceAlong(radiance,
                              std::span(directions).first(static_cast<std::size_t>(columns + 2)),
                              &centres[static_cast<std::size_t>((row + 1) * kStride)]);
            }
            for (int row = 0; row < rows; ++row) {
                glm::vec3* texel = &cube.texels(face)[static_cast<std::size_t>(firstRow + row) *
                                                          static_cast<std::size_t>(faceSize) +
                                                      static_cast<std::size_t>(firstColumn)];
                const glm::vec3* centre =
                    &centres[static_cast<std::size_t>((row + 1) * kStride + 1)];
                for (int i = 0; i < columns; ++i) {
                    const glm::vec3 c = centre[i], left = centre[i - 1], right = centre[i + 1],
                                    above = centre[i - kStride], below = centre[i + kStride];
                    const glm::vec3 least = min(min(min(left, right), min(above, below)), c);
                    const glm::vec3 most = max(max(max(left, right), max(above, below)), c);
                    excess[static_cast<std::size_t>(i)] = most - least - 0.05f * c - 1e-4f;
                }
                for (int column = 0; column < columns; ++column, ++centre) {
                    const glm::vec3 e = excess[static_cast<std::size_t>(column)];
                    if (std::max(e.x, std::max(e.y, e.z)) <= 0.0f) {
                        *texel++ = *centre;
                        continue;
                    }
                    for (int i = 0; i < kSamples * kSamples; ++i) {
                        const glm::vec2 at = glm::vec2(column, row) + gridPoint(i, kSamples);
                        directions[static_cast<std::size_t>(i)] = direction(at.x, at.y);
                    }
                    radianceAlong(radiance, std::span(directions).first(kSamples * kSamples),
                                  shown.data());
                    glm::vec3 sum(0.0f);
                    for (int i = 0; i < kSamples * kSamples; ++i)
                        sum += shown[static_cast<std::size_t>(i)];
                    *texel++ = sum / static_cast<float>(kSamples * kSamples);
                }
            }
        }
    });
    return cube;
}

}  // namespace tukor
