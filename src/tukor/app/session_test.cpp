#include "tukor/app/session.h"

#include <fstream>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tukor/base/error.h"
#include "tukor/base/file.h"
#include "tukor/base/parallel.h"
#include "tukor/base/test_folder.h"
#include "tukor/scene/gltf_test_file.h"

namespace tukor {
namespace {

using test::messageOf;
using testing::HasSubstr;

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

TEST(WithModels, KeepsNothingThatWasAboutTheOldOnes) {
    SessionOptions options;
    options.subject = {{"a.glb"}, {"gold", "lid=glass"}, "red", "walk", 2.0f, UpAxis::z, 0.001f,
                       0.5f};
    options.camera.camera = "front";
    options.light.environment = "sky";
    const SessionOptions other = withModels(options, {"b.glb"});
    SubjectOptions expected;
    expected.models = {"b.glb"};
    expected.dispersion = 0.5f;
    EXPECT_EQ(other.subject, expected);
    EXPECT_EQ(other.camera, CameraOptions{});
    EXPECT_EQ(other.light, options.light);
}

/// A file of the tetrahedron with other members; its path.
std::string writeTetrahedron(const TestFolder& folder, const std::string& name,
                             const std::string& more) {
    const std::string path = folder.path(name);
    std::ofstream(path) << test::tetrahedron(test::kOneMesh + (more.empty() ? "" : ", ") + more);
    return path;
}

TEST(Session, WantsAVariantAndAnAnimationToBeKnownToOneModel) {
    const TestFolder folder;
    SessionOptions options;
    options.light.faceSize = 8;
    options.subject.models = {
        writeTetrahedron(folder, "plain.gltf", ""),
        writeTetrahedron(folder, "rich.gltf", R"("extensions": {"KHR_materials_variants":
            {"variants": [{"name": "day"}, {"name": "night"}]}}, "animations": [
            {"name": "walk", "samplers": [], "channels": []}])")};
    const auto with = [&](const SubjectOptions& subject) {
        SessionOptions changed = options;
        changed.subject = subject;
        return messageOf([&] { (void)Session(changed); });
    };
    SubjectOptions both = options.subject;
    both.variant = "night";
    both.animation = "walk";
    both.timeSeconds = 1.0f;
    EXPECT_EQ(with(both), "no error");
    both.animation = "0";
    EXPECT_EQ(with(both), "no error");
    both.animation = "1";
    EXPECT_THAT(with(both), HasSubstr("animation '1' is unknown; known are: walk"));
    both.variant = "nigth";
    EXPECT_EQ(with(both), "variant 'nigth' is unknown; did you mean night? known are: day, night");

    SubjectOptions sphere;
    sphere.models = {"sphere"};
    sphere.variant = "day";
    EXPECT_EQ(with(sphere), "variant 'day': the model has no variants");
    sphere.variant.clear();
    sphere.animation = "walk";
    EXPECT_EQ(with(sphere), "animation 'walk': the model has no animations");
    sphere.animation.clear();
    sphere.timeSeconds = 1.0f;
    EXPECT_THAT(with(sphere), HasSubstr("time-seconds 1: the model has no animations"));
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
    const std::uint64_t own = session.sceneRevision();  // whose colours of vertices count
    options.subject.materials = {"gold+rough:0.2"};
    session.apply(options);
    EXPECT_NE(session.sceneRevision(), own);
}

TEST(Session, KeepsItsSceneFromOneRoughMaterialToAnother) {
    SessionOptions options;
    options.subject.models = {"sphere"};
    options.subject.materials = {"gold+rough:0.2"};
    options.light.faceSize = 8;
    Session session(options);
    const std::uint64_t golden = session.sceneRevision();
    options.subject.materials = {"glass+rough:0.3"};
    session.apply(options);
    EXPECT_EQ(session.sceneRevision(), golden);
    EXPECT_THAT(session.warnings(),
                testing::Contains(HasSubstr("gl refracts light in rough glass once")));
}

TEST(Session, IsUnchangedWhereOptionsCannotBeHad) {
    SessionOptions options;
    options.subject.models = {"brilliant"};
    options.light.faceSize = 8;
    options.quality.threads = 1;
    Session session(options);
    const int threads = threadCount();
    const Camera camera = session.camera();
    const Material material = session.scene().parts[0].material;
    const std::uint64_t revision = session.sceneRevision();
    const std::uint64_t environment = session.environmentRevision();
    const auto expectNothingChanged = [&](const SessionOptions& wrong) {
        EXPECT_NE(messageOf([&] { session.apply(wrong); }), "no error");
        EXPECT_EQ(session.options(), options);
        EXPECT_EQ(threadCount(), threads);
        EXPECT_EQ(session.camera(), camera);
        EXPECT_EQ(session.scene().parts.size(), 1u);
        EXPECT_EQ(session.scene().parts[0].material, material);
        EXPECT_TRUE(session.scene().lights.empty());
        EXPECT_EQ(session.sceneRevision(), revision);
        EXPECT_EQ(session.environmentRevision(), environment);
    };
    SessionOptions other = options;
    other.quality.threads = 2;
    other.subject.materials = {"gold"};
    other.light.environment = "sky";
    other.light.lights = {"0,1,0"};
    other.camera.eye = glm::vec3(1, 2, 3);
    SessionOptions wrong = other;
    wrong.subject.materials.emplace_back("glas");
    expectNothingChanged(wrong);
    wrong = other;
    wrong.camera.target = wrong.camera.eye;
    expectNothingChanged(wrong);
    wrong = other;
    wrong.subject.models = {"sphere", "none.obj"};
    expectNothingChanged(wrong);
    wrong = other;
    wrong.light.environment = "nowhere";
    expectNothingChanged(wrong);
    wrong = other;
    wrong.light.ground = "deep";
    expectNothingChanged(wrong);
    session.apply(other);
    EXPECT_EQ(session.options(), other);
    setThreadCount(0);
}

}  // namespace
}  // namespace tukor
