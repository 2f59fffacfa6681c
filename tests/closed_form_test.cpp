// Whole pictures against their closed form. A window of the 640 x 360 picture at its own scale
// keeps each below a second or two; bench/accuracy does the full ones.
#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "acceptance/subjects.h"
#include "oracle/equirect.h"
#include "tukor/image/compare.h"

namespace tukor::acceptance {
namespace {

constexpr int kWidth = 128;
constexpr int kHeight = 72;

// Errors are those of the sphere, which fills a half of the window but 0.22 of the whole picture.
constexpr double kWindowFactor = 1.5;  // sqrt(0.5 / 0.22)

/// A fifth of the 640 x 360 view from (0, 0, 4) at 40 degrees: half of it sphere with its edge,
/// half background.
Camera windowCamera() {
    Camera camera;
    camera.target = glm::vec3(0.75f, 0.45f, 0.0f);
    camera.verticalFov = 2.0f * std::atan(std::tan(0.5f * camera.verticalFov) / 5.0f);
    return camera;
}

struct Light {
    std::string name;
    Environment environment;
    oracle::Environment truth;
};

/// The studio, as its cube map shows it: what the cube keeps of a photograph is bench/accuracy's
/// and the environment tests' business.
std::vector<Light> lights() {
    std::vector<Light> all;
    Environment studio = loadEnvironment("studio");
    const auto cube = std::make_shared<CubeMap>(studio.radiance);
    all.push_back({"studio", std::move(studio), [cube](glm::vec3 d) { return cube->radiance(d); }});
    return all;
}

class ClosedForm : public testing::TestWithParam<Trial> {};

TEST_P(ClosedForm, IsWhatTheRendererDraws) {
    const Trial& trial = GetParam();
    static const std::vector<Light> kLights = lights();
    for (const Light& light : kLights) {
        const Image truth =
            expected(trial.subject, light.truth, windowCamera(), kWidth, kHeight, 12);
        const Rendering rendering =
            rendered(trial, light.environment, windowCamera(), kWidth, kHeight);
        const Comparison comparison = compareImages(rendering.radiance, truth);
        EXPECT_LE(comparison.rmse8, kWindowFactor * trial.limit)
            << describe(trial.subject) << ", " << describe(trial) << ", " << light.name << '\n'
            << report(comparison);
        EXPECT_EQ(comparison.nonFinite, 0u);
        EXPECT_EQ(rendering.leaks, 0u);
        EXPECT_EQ(rendering.inconsistencies, 0u);
        RecordProperty("rmse8", std::to_string(comparison.rmse8));
    }
}

std::string testName(const testing::TestParamInfo<Trial>& info) {
    std::string name = describe(info.param.subject) + " " + describe(info.param);
    for (char& c : name) {
        if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
    }
    return name;
}

/// Those with the full number of samples, without gl's solids, which take software OpenGL too long:
/// bench/accuracy has those.
std::vector<Trial> quickTrials() {
    std::vector<Trial> quick;
    for (const Trial& trial : trials()) {
        const bool glSolid = trial.renderer == Renderer::gl && trial.subject.truth == Truth::solid;
        if (trial.samples && !glSolid) quick.push_back(trial);
    }
    return quick;
}

INSTANTIATE_TEST_SUITE_P(Spheres, ClosedForm, testing::ValuesIn(quickTrials()), testName);

/// The left edge of the ball at the scale of 640 x 360, where the lamps of a night are slivers of
/// the pixels: 3.7 here, which is 0.3 in the whole picture, and 12.2 if grazing samples are not
/// taken again.
TEST(ClosedFormRims, OfGlassShowTheLampsOfANight) {
    constexpr const char* kNight = "/usr/share/blender/datafiles/studiolights/world/night.exr";
    ASSERT_TRUE(std::filesystem::exists(kNight)) << "needs Debian's blender-data";
    constexpr int kSide = 36;
    Camera camera;
    camera.target = glm::vec3(-0.97f, 0.05f, 0.0f);
    camera.verticalFov = 2.0f * std::atan(std::tan(0.5f * camera.verticalFov) * kSide / 360.0f);
    const Trial trial{{"glass", Truth::solid}, Renderer::gl, Fidelity::exact, 64, 6.0};
    const Environment night = loadEnvironment(kNight);
    const Image truth =
        expected(trial.subject, oracle::equirect(*night.panorama), camera, kSide, kSide, 32);
    const Rendering rendering = rendered(trial, night, camera, kSide, kSide);
    const Comparison comparison = compareImages(rendering.radiance, truth);
    EXPECT_LE(comparison.rmse8, trial.limit) << report(comparison);
}

}  // namespace
}  // namespace tukor::acceptance
