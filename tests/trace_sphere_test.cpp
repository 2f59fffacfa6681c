// The CPU renderer against pictures known in closed form: spheres under photographs.
#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>

#include "oracle/closed_form.h"
#include "oracle/equirect.h"
#include "tukor/geometry/shapes.h"
#include "tukor/materials/materials.h"
#include "tukor/trace/render.h"

namespace tukor {
namespace {

const std::filesystem::path kPhotographs = "/usr/share/blender/datafiles/studiolights/world";

double srgb8(float radiance) {
    const double x = std::clamp(static_cast<double>(radiance), 0.0, 1.0);
    return 255.0 * (x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055);
}

double rmse8(const Image& a, const Image& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.pixels().size(); ++i) {
        for (int c = 0; c < 3; ++c) {
            const double step = srgb8(a.pixels()[i][c]) - srgb8(b.pixels()[i][c]);
            sum += step * step;
        }
    }
    return std::sqrt(sum / (3.0 * static_cast<double>(a.pixels().size())));
}

/// RMSE in 8-bit sRGB of a sphere at 64 samples a pixel against its closed form at 256.
double errorOf(const std::string& material, const std::string& photograph, int width, int height) {
    const Environment environment =
        loadEnvironment((kPhotographs / (photograph + ".exr")).string());
    const oracle::Environment light = oracle::equirect(*environment.panorama);
    Scene scene;
    scene.parts.push_back(
        {"sphere", "", parseMaterial(material), std::move((*makeShape("sphere"))[0].mesh)});
    RenderOptions options;
    options.width = width;
    options.height = height;
    options.samples = 64;
    const Material& m = scene.parts[0].material;
    const oracle::View view = m.kind == MaterialKind::dielectric
                                  ? oracle::solidSphere(m, light)
                                  : oracle::reflectingSphere(m, light);
    const Image truth = oracle::picture(Camera{}, options.width, options.height, 16, view);
    return rmse8(trace::render(scene, environment, Camera{}, options).radiance, truth);
}

class TraceSphere : public testing::TestWithParam<std::string> {
protected:
    void SetUp() override {
        ASSERT_TRUE(std::filesystem::exists(kPhotographs)) << "needs Debian's blender-data";
    }
};

#ifndef TUKOR_SWEEP
TEST_P(TraceSphere, EqualsItsClosedForm) {
    EXPECT_LT(errorOf(GetParam(), "courtyard", 320, 180), 0.5);
}

INSTANTIATE_TEST_SUITE_P(Materials, TraceSphere, testing::Values("glass", "gold"));

#else
using TraceSphereSweep = TraceSphere;

TEST_P(TraceSphereSweep, EqualsItsClosedFormUnderEveryPhotograph) {
    for (const char* photograph :
         {"city", "courtyard", "forest", "interior", "night", "studio", "sunrise", "sunset"}) {
        EXPECT_LT(errorOf(GetParam(), photograph, 640, 360), 0.5) << photograph;
    }
}

INSTANTIATE_TEST_SUITE_P(Slow, TraceSphereSweep,
                         testing::Values("glass", "water", "ior:1.2", "ior:2.42", "gold",
                                         "silver"));
#endif

}  // namespace
}  // namespace tukor
