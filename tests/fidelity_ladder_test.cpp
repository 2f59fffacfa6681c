// Each level of fidelity is nearer to the truth than the one below it, in both renderers.
#include <string>
#include <tuple>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tukor/environment/environment.h"
#include "tukor/gl/render.h"
#include "tukor/image/compare.h"
#include "tukor/scene/model_file.h"
#include "tukor/trace/render.h"

namespace tukor {
namespace {

using ShapeAndLight = std::tuple<const char*, const char*>;
class FidelityLadder : public testing::TestWithParam<ShapeAndLight> {};

TEST_P(FidelityLadder, DoubleIsNearerToExactThanSingle) {
    ModelOptions asGlass;
    asGlass.material = "glass";
    const auto& [shape, environment] = GetParam();
    const Scene scene = loadModel(shape, asGlass);
    const Environment light = loadEnvironment(environment);
    const Camera camera = framingCamera(scene, 16.0f / 9.0f);
    RenderOptions options;
    options.width = 128;
    options.height = 72;
    options.samples = 4;
    const Image truth = trace::render(scene, light, camera, options).radiance;
    for (const bool onGpu : {false, true}) {
        const auto distance = [&](Fidelity fidelity) {
            options.fidelity = fidelity;
            const Rendering rendering = onGpu ? gl::render(scene, light, camera, options)
                                              : trace::render(scene, light, camera, options);
            return compareImages(rendering.radiance, truth).rmse8;
        };
        const double single = distance(Fidelity::single), two = distance(Fidelity::two);
        fmt::print("{} {} {}: single {:.1f}, double {:.1f}\n", onGpu ? "gl" : "trace", shape,
                   environment, single, two);
        EXPECT_LT(two, single);
    }
}

INSTANTIATE_TEST_SUITE_P(Shapes, FidelityLadder,
                         testing::Combine(testing::Values("sphere", "torus-knot", "tumbler"),
                                          testing::Values("sky", "studio")),
                         [](const testing::TestParamInfo<ShapeAndLight>& tested) {
                             std::string name = std::get<0>(tested.param);
                             name = name + "_" + std::get<1>(tested.param);
                             std::erase(name, '-');
                             return name;
                         });

}  // namespace
}  // namespace tukor
