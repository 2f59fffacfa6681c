// What a cube map's texel should be where it is coarser than the panorama: the benchmarks' truth.
#pragma once
#include <algorithm>
#include <cmath>

#include "tukor/environment/cube_texel.h"
#include "tukor/image/image.h"

namespace tukor {

/// The mean of the pixels, as areas of one value, over a texel's solid angle: 256 x 256 points.
///
/// `mirror` multiplies directions, for faces of other handedness.
inline glm::dvec3 exactTexelMean(const Image& image, CubeTexel texel, int faceSize,
                                 glm::dvec3 mirror = glm::dvec3(1.0)) {
    constexpr int kPoints = 256;
    glm::dvec3 sum(0.0);
    double weights = 0.0;
    const glm::dvec3 middle(directionFromCube({texel.face, 0.0f, 0.0f}));
    const glm::dvec3 right = glm::dvec3(directionFromCube({texel.face, 1.0f, 0.0f})) - middle;
    const glm::dvec3 down = glm::dvec3(directionFromCube({texel.face, 0.0f, 1.0f})) - middle;
    for (int i = 0; i < kPoints * kPoints; ++i) {
        const double s = 2.0 * (texel.column + (i % kPoints + 0.5) / kPoints) / faceSize - 1.0;
        const double t = 2.0 * (texel.row + (i / kPoints + 0.5) / kPoints) / faceSize - 1.0;
        const glm::dvec3 d = mirror * (middle + s * right + t * down);
        const double x = (std::atan2(d.x, -d.z) / (2.0 * M_PI) + 0.5) * image.width();
        const double y = std::atan2(std::hypot(d.x, d.z), d.y) / M_PI * image.height();
        const double weight = std::pow(1.0 + s * s + t * t, -1.5);
        sum +=
            weight * glm::dvec3(image.at(std::clamp(static_cast<int>(x), 0, image.width() - 1),
                                         std::clamp(static_cast<int>(y), 0, image.height() - 1)));
        weights += weight;
    }
    return sum / weights;
}

}  // namespace tukor
