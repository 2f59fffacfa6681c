// What a cube map from a panorama costs and how far it is from exact area averages.
//
// usage: cube_conversion [PANORAMA FACE_SIZE]...
//
// Without arguments: the built-in sky and studio at 4096 x 2048 to faces of 1024, at 1024 x 512 to
// faces of 512. Prints the CPU seconds of the conversion alone (least of five), of its first run
// (fresh memory), and where texels are averages the relative root mean square and worst error of
// 600 of them against means of 256 x 256 points of each.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <sys/resource.h>

#include "tukor/environment/cube_texel.h"
#include "tukor/environment/equirect.h"
#include "tukor/environment/panorama.h"
#include "tukor/environment/procedural.h"
#include "tukor/environment/repair.h"
#include "tukor/image/image_file.h"

namespace tukor {
namespace {

double cpuSeconds() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
           1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

/// The mean of the pixels, as areas of one value, over a texel's solid angle.
glm::dvec3 exactMean(const Image& image, CubeTexel texel, int faceSize) {
    constexpr int kPoints = 256;
    glm::dvec3 sum(0.0);
    double weights = 0.0;
    const glm::dvec3 middle(directionFromCube({texel.face, 0.0f, 0.0f}));
    const glm::dvec3 right = glm::dvec3(directionFromCube({texel.face, 1.0f, 0.0f})) - middle;
    const glm::dvec3 down = glm::dvec3(directionFromCube({texel.face, 0.0f, 1.0f})) - middle;
    for (int i = 0; i < kPoints * kPoints; ++i) {
        const double s = 2.0 * (texel.column + (i % kPoints + 0.5) / kPoints) / faceSize - 1.0;
        const double t = 2.0 * (texel.row + (i / kPoints + 0.5) / kPoints) / faceSize - 1.0;
        const glm::dvec3 d = middle + s * right + t * down;
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

void measure(const std::string& name, const Image& panorama, int faceSize) {
    std::vector<double> seconds;
    CubeMap cube(1);
    for (int i = 0; i < 5; ++i) {
        const double before = cpuSeconds();
        cube = cubeFromEquirect(panorama, faceSize);
        seconds.push_back(cpuSeconds() - before);
    }
    fmt::print("{:12} {:5} x {:4} -> {:4}: {:.3f} CPU-s, {:.3f} at first", name, panorama.width(),
               panorama.height(), faceSize, *std::min_element(seconds.begin(), seconds.end()),
               seconds.front());
    if (static_cast<double>(faceSize) < panorama.width() / M_PI) {
        std::mt19937 random(3);
        double error = 0.0, size = 0.0, worst = 0.0;
        for (int i = 0; i < 600; ++i) {
            const auto place = [&] {
                return static_cast<int>(random() % static_cast<unsigned>(faceSize));
            };
            const CubeTexel texel{static_cast<CubeFace>(i % 6), place(), place()};
            const glm::dvec3 exact = exactMean(panorama, texel, faceSize);
            const glm::dvec3 got(cube.texels(
                texel.face)[static_cast<std::size_t>(texel.row * faceSize + texel.column)]);
            error += glm::dot(got - exact, got - exact);
            size += glm::dot(exact, exact);
            worst = std::max(worst, glm::length(got - exact) / glm::length(exact));
        }
        fmt::print(", error {:.1e}, worst {:.1e}", std::sqrt(error / size), worst);
    }
    fmt::print("\n");
}

Image loadPanorama(const std::string& path) {
    Image panorama = loadImage(path);
    (void)repairRadiance(panorama);
    return panorama;
}

void run(int count, char** words) {
    for (int i = 0; i + 1 < count; i += 2)
        measure(words[i], loadPanorama(words[i]), std::atoi(words[i + 1]));
    if (count > 0) return;
    for (const auto& [width, faceSize] : {std::pair(4096, 1024), std::pair(1024, 512)}) {
        measure("sky", panoramaFromCube(skyCube(width / 4), width), faceSize);
        measure("studio", panoramaFromCube(studioCube(width / 4), width), faceSize);
    }
    // Every pixel differs from its neighbours: what smooth skies hide.
    std::mt19937 random(5);
    std::uniform_real_distribution<float> even(0.5f, 1.5f);
    Image noise(4096, 2048);
    for (glm::vec3& pixel : noise.pixels()) pixel = {even(random), even(random), even(random)};
    measure("noise", noise, 1024);
}

}  // namespace
}  // namespace tukor

int main(int argc, char** argv) {
    try {
        tukor::run(argc - 1, argv + 1);
        return 0;
    } catch (const std::exception& error) {
        fmt::print(stderr, "cube_conversion: {}\n", error.what());
        return 1;
    }
}
