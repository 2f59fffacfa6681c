// What a cube map from a panorama costs and how far it is from exact area averages.
//
// usage: cube_conversion [PANORAMA FACE_SIZE]...
//
// Without arguments: the built-in sky and studio at 4096 x 2048 to faces of 1024, at 1024 x 512 to
// faces of 512. Prints the CPU seconds of the conversion alone (least of five), of its first run
// and what the system took of that, and where texels are averages the relative root mean square and
// worst error of 600 of them against means of 256 x 256 points of each.
//
// Memory that a virtual machine has never handed out before costs its host's time, which counts as
// the system's: as much as the cube takes is used once before.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <sys/resource.h>

#include "texel_mean.h"
#include "tukor/environment/equirect.h"
#include "tukor/environment/panorama.h"
#include "tukor/environment/procedural.h"
#include "tukor/environment/repair.h"
#include "tukor/image/image_file.h"

namespace tukor {
namespace {

struct Cpu {
    double all = 0.0;
    double system = 0.0;
};

Cpu cpuSeconds() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](timeval time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    return {seconds(usage.ru_utime) + seconds(usage.ru_stime), seconds(usage.ru_stime)};
}

void measure(const std::string& name, const Image& panorama, int faceSize) {
    std::vector<Cpu> seconds;
    CubeMap cube(1);
    (void)CubeMap(faceSize);
    for (int i = 0; i < 5; ++i) {
        const Cpu before = cpuSeconds();
        cube = cubeFromEquirect(panorama, faceSize);
        const Cpu after = cpuSeconds();
        seconds.push_back({after.all - before.all, after.system - before.system});
    }
    const auto least = std::min_element(seconds.begin(), seconds.end(),
                                        [](Cpu a, Cpu b) { return a.all < b.all; });
    fmt::print("{:12} {:5} x {:4} -> {:4}: {:.3f} CPU-s, {:.3f} at first ({:.3f} system)", name,
               panorama.width(), panorama.height(), faceSize, least->all, seconds.front().all,
               seconds.front().system);
    if (static_cast<double>(faceSize) < panorama.width() / M_PI) {
        std::mt19937 random(3);
        double error = 0.0, size = 0.0, worst = 0.0;
        for (int i = 0; i < 600; ++i) {
            const auto place = [&] {
                return static_cast<int>(random() % static_cast<unsigned>(faceSize));
            };
            const CubeTexel texel{static_cast<CubeFace>(i % 6), place(), place()};
            const glm::dvec3 exact = exactTexelMean(panorama, texel, faceSize);
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
