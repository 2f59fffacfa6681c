#include "tukor/app/session.h"

#include <functional>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tukor/base/error.h"
#include "tukor/base/file.h"
#include "tukor/base/test_folder.h"

namespace tukor {
namespace {

using testing::HasSubstr;

std::string messageOf(const std::function<void()>& action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

TEST(LightFromText, ComesFromWhereItSays) {
    const Light light = lightFromText("0,2,0/1,0.5,0");
    EXPECT_EQ(light.kind, LightKind::directional);
    EXPECT_EQ(light.direction, glm::vec3(0, -1, 0));
    // On a white matt surface its colour: E / pi.
    EXPECT_EQ(light.intensity, std::numbers::pi_v<float> * glm::vec3(1.0f, 0.5f, 0.0f));
    EXPECT_THAT(messageOf([] { (void)lightFromText("0,0,0"); }), HasSubstr("no direction"));
    EXPECT_THAT(messageOf([] { (void)lightFromText("up"); }),
                HasSubstr("expected X,Y,Z or X,Y,Z/R,G,B"));
    EXPECT_THAT(messageOf([] { (void)lightFromText("0,1,0/-1,0,0"); }), HasSubstr("light"));
}

TEST(GroundFromText, LiesUnderTheModelOrWhereItSays) {
    Scene scene;
    scene.parts.emplace_back();
    scene.parts[0].mesh.positions = {{0, -2, 0}, {1, 3, 1}};
    EXPECT_FALSE(groundFromText("", scene).has_value());
    EXPECT_EQ(groundFromText("lowest", scene), -2.0f);
    EXPECT_EQ(groundFromText("0.5", scene), 0.5f);
    EXPECT_THAT(messageOf([&] { (void)groundFromText("low", scene); }),
                HasSubstr("expected a height in metres, or lowest"));
}

TEST(Session, AddsLightsAndDispersionToTheModels) {
    SessionOptions options;
    options.subject.models = {"brilliant"};
    options.subject.materials = {"diamond"};
    options.light.lights = {"0,1,0"};
    options.light.faceSize = 8;
    Session session(options);
    EXPECT_EQ(session.scene().lights.size(), 1u);
    EXPECT_EQ(session.scene().parts[0].material.dispersion, 0.0f);
    options.subject.dispersion = 2.0f;
    options.light.lights.clear();
    options.light.ground = "lowest";
    options.quality.fidelity = Fidelity::single;
    session.apply(options);
    EXPECT_TRUE(session.scene().lights.empty());
    EXPECT_FLOAT_EQ(session.scene().parts[0].material.dispersion, 2.0f * 20.0f / 55.3f);
    EXPECT_THAT(session.warnings(), testing::IsSupersetOf({HasSubstr("gl draws dispersion of"),
                                                           HasSubstr("gl draws no ground")}));
    options.light.ground = "deep";
    EXPECT_THAT(messageOf([&] { session.apply(options); }), HasSubstr("ground: 'deep'"));
}

TEST(Session, HasAnotherSceneWhereFinishesAppear) {
    const TestFolder folder;
    writeFile(folder.path("a.mtl"), std::string_view("newmtl m\nKd 1 1 1\nPr 0.5\n"));
    writeFile(folder.path("a.obj"),
              std::string_view("mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n"));
    SessionOptions options;
    options.subject.models = {folder.path("a.obj")};
    options.subject.materials = {"gold"};
    options.light.faceSize = 8;
    Session session(options);
    const std::uint64_t golden = session.sceneRevision();
    options.subject.materials = {"silver"};
    session.apply(options);
    EXPECT_EQ(session.sceneRevision(), golden);
    options.subject.materials.clear();
    session.apply(options);
    EXPECT_NE(session.scene().parts[0].material.finish, nullptr);
    EXPECT_NE(session.sceneRevision(), golden);
}

}  // namespace
}  // namespace tukor
