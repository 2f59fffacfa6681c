#include "tukor/environment/local_gather.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "tukor/base/parallel.h"
#include "tukor/environment/cube_mips.h"
#include "tukor/environment/cube_texel.h"
#include "tukor/environment/equirect.h"

namespace tukor {

namespace {

/// One look-up: an offset from the middle and the level whose texels have its share of solid angle.
struct Sample {
    glm::vec3 offset;  // z along the middle
    std::size_t level;
    float weight;
};

/// Rings of equal probability of the half vector [Walter et al. 2007], with points turned by the
/// golden angle from ring to ring; weighted by the cosine as lobeWeight is.
std::vector<Sample> samplesOf(const Lobe& lobe, int baseSize, std::size_t levels) {
    constexpr int kCount = 256;
    const double a2 = lobe.alpha * lobe.alpha;
    std::vector<Sample> samples;
    double whole = 0.0;
    for (int i = 0; i < kCount; ++i) {
        // The half vector reaches 45 degrees, beyond which the light comes from below the surface.
        const double most = 0.5 / (1.0 + (a2 - 1.0) * 0.5);
        const double u = most * (i + 0.5) / kCount;
        const double cos2 = (1.0 - u) / (1.0 + (a2 - 1.0) * u);
        const double cosTheta = 2.0 * cos2 - 1.0;
        const double sinTheta = std::sqrt(std::max(0.0, 1.0 - cosTheta * cosTheta));
        const double phi = i * std::numbers::pi * (3.0 - std::sqrt(5.0));
        const double f = (a2 - 1.0) * cos2 + 1.0;
        const double density = a2 / (std::numbers::pi * f * f) / 4.0 / most;
        const double texel = 4.0 * std::numbers::pi / (6.0 * baseSize * baseSize);
        // A third of the sample's share: bilinear look-ups in coarser texels would blur on their
        // own.
        const double level = 0.5 * std::log2(1.0 / (kCount * density) / (3.0 * texel));
        samples.push_back({{sinTheta * std::cos(phi), sinTheta * std::sin(phi), cosTheta},
                           static_cast<std::size_t>(std::clamp(std::floor(level + 0.5), 0.0,
                                                               static_cast<double>(levels - 1))),
                           static_cast<float>(cosTheta)});
        whole += cosTheta;
    }
    for (Sample& sample : samples) sample.weight /= static_cast<float>(whole);
    return samples;
}

}  // namespace

CubeMap gatheredCube(const Image& panorama, const Lobe& lobe, int faceSize) {
    std::vector<CubeMap> chain;
    chain.push_back(cubeFromEquirect(panorama, faceSizeForEquirect(panorama.width())));
    for (CubeMap& mip : cubeMips(chain.front())) chain.push_back(std::move(mip));
    const std::vector<Sample> samples = samplesOf(lobe, chain.front().faceSize(), chain.size());
    CubeMap cube(faceSize);
    parallelFor(0, 6 * faceSize, 4, [&](int begin, int end) {
        for (int line = begin; line < end; ++line) {
            const auto face = static_cast<CubeFace>(line / faceSize);
            const int row = line % faceSize;
            for (int column = 0; column < faceSize; ++column) {
                const glm::vec3 middle =
                    glm::normalize(directionFromTexel({face, column, row}, faceSize));
                const glm::vec3 x = glm::normalize(glm::cross(
                    std::abs(middle.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0), middle));
                const glm::vec3 y = glm::cross(middle, x);
                glm::vec3 sum(0.0f);
                for (const Sample& sample : samples)
                    sum += sample.weight *
                           chain[sample.level].radiance(sample.offset.x * x + sample.offset.y * y +
                                                        sample.offset.z * middle);
                cube.texels(
                    face)[static_cast<std::size_t>(row) * static_cast<std::size_t>(faceSize) +
                          static_cast<std::size_t>(column)] = sum;
            }
        }
    });
    return cube;
}

}  // namespace tukor
