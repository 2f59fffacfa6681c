// How far `gl`'s split sum is from `trace` on rough spheres, as the table of docs/features.md.
//
//     rough_spheres [--samples N] [ENVIRONMENT...]
//
// 96x96, `studio` and blender-data's forest unless told otherwise. RMSE over the sphere's pixels in
// codes of 8-bit sRGB of the clipped linear picture; the noise of trace, as two seeds differ, is
// beside it. Means of radiance are over the whole sphere, gl over trace.
#include <cmath>
#include <cstdio>
#include <cstring>
#include <exception>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "tukor/environment/environment.h"
#include "tukor/geometry/sphere.h"
#include "tukor/gl/render.h"
#include "tukor/image/compare.h"
#include "tukor/materials/materials.h"
#include "tukor/scene/finish.h"
#include "tukor/trace/render.h"

namespace {

using namespace tukor;

Scene sphereOf(float metallic, float roughness) {
    Finish finish;
    finish.metallic = metallic;
    finish.roughness = roughness;
    finish.baseColor =
        metallic > 0.5f ? glm::vec3(1.0f, 0.77f, 0.34f) : glm::vec3(0.5f, 0.05f, 0.04f);
    Scene scene;
    scene.parts.push_back({"sphere", "", mirrorMaterial(finish.baseColor), makeSphere(40)});
    scene.parts[0].material.finish = std::make_shared<Finish>(finish);
    return scene;
}

/// The pixels that the sphere fills, as one row.
Image filled(const Image& image, const Image& coverage) {
    std::vector<glm::vec3> pixels;
    for (std::size_t i = 0; i < image.pixels().size(); ++i)
        if (coverage.alpha[i] > 0.999f) pixels.push_back(image.pixels()[i]);
    Image row(static_cast<int>(pixels.size()), 1);
    std::copy(pixels.begin(), pixels.end(), row.pixels().begin());
    return row;
}

double mean(const Image& image) {
    double sum = 0.0;
    for (const glm::vec3& pixel : image.pixels())
        sum += static_cast<double>(pixel.x + pixel.y + pixel.z);
    return sum / static_cast<double>(image.pixels().size());
}

}  // namespace

int main(int argc, char** argv) try {
    int samples = 256;
    std::vector<std::string> environments;
    for (int i = 1; i < argc; ++i) {
        if (std::strcmp(argv[i], "--samples") == 0 && i + 1 < argc)
            samples = std::atoi(argv[++i]);
        else
            environments.emplace_back(argv[i]);
    }
    if (environments.empty())
        environments = {"studio", "/usr/share/blender/datafiles/studiolights/world/forest.exr"};
    fmt::print("| environment | sphere | roughness | RMSE | noise of trace | mean, gl / trace |\n");
    fmt::print("|---|---|---|---|---|---|\n");
    for (const std::string& name : environments) {
        const Environment light = loadEnvironment(name);
        const auto slash = name.find_last_of('/');
        const std::string shown = slash == name.npos ? name : name.substr(slash + 1);
        for (const float metallic : {1.0f, 0.0f})
            for (const float roughness : {0.1f, 0.2f, 0.4f, 0.6f, 0.8f, 1.0f}) {
                const Scene scene = sphereOf(metallic, roughness);
                RenderOptions options;
                options.width = options.height = 96;
                options.background = Background::none;
                options.samples = 16;
                const Camera camera = framingCamera(scene, 1.0f);
                const Image drawn = gl::render(scene, light, camera, options).radiance;
                options.samples = samples;
                const Image traced = trace::render(scene, light, camera, options).radiance;
                options.seed = 1;
                const Image again = trace::render(scene, light, camera, options).radiance;
                const Image a = filled(drawn, drawn), b = filled(traced, drawn);
                fmt::print("| {} | {} | {:.1f} | {:.1f} | {:.1f} | {:.3f} |\n", shown,
                           metallic > 0.5f ? "gold" : "red plastic", roughness,
                           compareImages(a, b).rmse8,
                           compareImages(b, filled(again, drawn)).rmse8 / std::sqrt(2.0),
                           mean(a) / mean(b));
                std::fflush(stdout);
            }
    }
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "rough_spheres: %s\n", error.what());
    return 2;
}
