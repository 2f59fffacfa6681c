// How far a filtered chain is from exact quadrature over the panorama's pixels.
//
// usage: chain_error PANORAMA PATTERN LEVELS [filament]
//
// PATTERN has {level} and {face} (px nx py ny pz nz). `filament`: faces by cmgen --no-mirror, whose
// panoramas have +Z in the middle. Roughness by Filament's scale. Prints for each level its alpha,
// relative root mean square error and worst texel; level 0 against means over texels.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <random>
#include <string>
#include <string_view>

#include <fmt/args.h>
#include <fmt/format.h>

#include "texel_mean.h"
#include "tukor/base/parallel.h"
#include "tukor/environment/cube_texel.h"
#include "tukor/environment/layout.h"
#include "tukor/environment/prefilter.h"
#include "tukor/environment/repair.h"
#include "tukor/image/image_file.h"

namespace tukor {
namespace {

constexpr double kPi = std::numbers::pi;

/// The lobe's mean of the panorama: every pixel, those near the middle in 8 x 8 parts.
glm::dvec3 exactMean(const Image& image, const Lobe& lobe, glm::dvec3 middle) {
    const int width = image.width(), height = image.height();
    const double nearCosine = std::cos(std::min(12 * lobe.alpha + 3 * kPi / height, 0.5 * kPi));
    glm::dvec3 sum(0.0);
    double weights = 0.0;
    for (int row = 0; row < height; ++row) {
        const double theta = kPi * (row + 0.5) / height;
        for (int column = 0; column < width; ++column) {
            const double phi = 2 * kPi * ((column + 0.5) / width - 0.5);
            const auto cosineAt = [&](double t, double p) {
                return std::sin(t) * (std::sin(p) * middle.x - std::cos(p) * middle.z) +
                       std::cos(t) * middle.y;
            };
            const double cosine = cosineAt(theta, phi);
            if (cosine < -2 * kPi / height) continue;
            const int parts = cosine > nearCosine && lobe.alpha < 0.2 ? 8
                              : std::abs(cosine) < 2 * kPi / height   ? 4
                                                                      : 1;
            double weight = 0.0;
            for (int i = 0; i < parts * parts; ++i) {
                const double t = kPi * (row + (i / parts + 0.5) / parts) / height;
                const double p = 2 * kPi * ((column + (i % parts + 0.5) / parts) / width - 0.5);
                weight += lobeWeight(lobe, parts == 1 ? cosine : cosineAt(t, p)) * std::sin(t);
            }
            weight /= parts * parts;
            sum += weight * glm::dvec3(image.at(column, row));
            weights += weight;
        }
    }
    return sum / weights;
}

int run(const std::string& panoramaPath, const std::string& pattern, int levels, bool filament) {
    Image panorama = loadImage(panoramaPath);
    (void)repairRadiance(panorama);
    const std::vector<double> alphas = chainAlphas({.levels = levels});
    // A fixed share of the work for each level: sampled texels, the same for every program.
    const int samples = panorama.width() > 2048 ? 16 : 64;
    for (int level = 0; level < levels; ++level) {
        std::array<Image, 6> faces;
        std::array<std::string, 6> names;
        for (std::size_t i = 0; i < 6; ++i) {
            names[i] = fmt::format(fmt::runtime(pattern), fmt::arg("level", level),
                                   fmt::arg("face", kFaceNames[0][i]));
            faces[i] = loadImage(names[i]);
        }
        const CubeMap cube = cubeFromFaces(faces, names);
        std::mt19937 random(7);
        std::vector<CubeTexel> texels;
        for (int i = 0; i < samples; ++i)
            texels.push_back({static_cast<CubeFace>(random() % 6),
                              static_cast<int>(random() % static_cast<unsigned>(cube.faceSize())),
                              static_cast<int>(random() % static_cast<unsigned>(cube.faceSize()))});
        std::vector<glm::dvec3> exact(texels.size());
        parallelFor(0, samples, 1, [&](int begin, int end) {
            for (int i = begin; i < end; ++i) {
                if (level == 0) {
                    exact[static_cast<std::size_t>(i)] =
                        exactTexelMean(panorama, texels[static_cast<std::size_t>(i)],
                                       cube.faceSize(), {1.0, 1.0, filament ? -1.0 : 1.0});
                    continue;
                }
                glm::dvec3 direction(glm::normalize(
                    directionFromTexel(texels[static_cast<std::size_t>(i)], cube.faceSize())));
                if (filament) direction.z = -direction.z;
                exact[static_cast<std::size_t>(i)] = exactMean(
                    panorama, {LobeShape::ggx, alphas[static_cast<std::size_t>(level)]}, direction);
            }
        });
        double error = 0.0, size = 0.0, worst = 0.0;
        for (std::size_t i = 0; i < texels.size(); ++i) {
            const glm::dvec3 got(cube.texels(texels[i].face)[static_cast<std::size_t>(
                texels[i].row * cube.faceSize() + texels[i].column)]);
            error += glm::dot(got - exact[i], got - exact[i]);
            size += glm::dot(exact[i], exact[i]);
            worst = std::max(worst, glm::length(got - exact[i]) / glm::length(exact[i]));
        }
        fmt::print("{} {:.4f} {:.3e} {:.3e}\n", level, alphas[static_cast<std::size_t>(level)],
                   std::sqrt(error / size), worst);
    }
    return 0;
}

}  // namespace
}  // namespace tukor

int main(int argc, char** argv) {
    if (argc < 4) {
        fmt::print(stderr, "usage: chain_error PANORAMA PATTERN LEVELS [filament]\n");
        return 2;
    }
    try {
        return tukor::run(argv[1], argv[2], std::atoi(argv[3]),
                          argc > 4 && std::string_view(argv[4]) == "filament");
    } catch (const std::exception& error) {
        fmt::print(stderr, "chain_error: {}\n", error.what());
        return 1;
    }
}
