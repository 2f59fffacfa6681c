#include "tukor/app/series.h"

#include <fstream>
#include <optional>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tukor/app/picture.h"
#include "tukor/app/session.h"
#include "tukor/base/test_folder.h"
#include "tukor/scene/gltf_test_file.h"
#include "tukor/scene/model_file.h"

namespace tukor {
namespace {

TEST(Turntable, NumbersItsPictures) {
    EXPECT_EQ(numberedPath("a/turn.png", 7), "a/turn-0007.png");
    EXPECT_EQ(numberedPath("a/turn-####.png", 12345), "a/turn-12345.png");
    EXPECT_EQ(numberedPath("##_of_###.exr", 7), "##_of_007.exr");
    EXPECT_EQ(numberedPath("a#/#", 3), "a#/3");
}

TEST(Turntable, ShowsASphereAsItIsFromAllSides) {
    SessionOptions options;
    options.subject.models = {"sphere"};
    options.light.environment = "sky";
    options.light.rotationDegrees = 100.0f;
    options.light.lights = {"1,2,3/1,0.5,0.25"};
    options.light.faceSize = 64;
    options.quality.size = {32, 18};
    options.quality.samples = 4;
    Session session(options);
    const Camera camera = session.camera();
    const Image first = renderPicture(session).radiance;
    for (int i = 1; i < 4; ++i) {
        session.apply(turntableOptions(options, camera, i, 4));
        EXPECT_NE(session.camera().eye, camera.eye);
        const Image next = renderPicture(session).radiance;
        double off = 0.0;
        for (std::size_t p = 0; p < first.pixels().size(); ++p) {
            const glm::vec3 step = first.pixels()[p] - next.pixels()[p];
            off += static_cast<double>(length(step) / (1.0f + length(first.pixels()[p])));
        }
        EXPECT_LT(off / static_cast<double>(first.pixels().size()), 0.02) << i;
    }
}

TEST(Turntable, TurnsTheModelCounterClockwiseSeenFromAbove) {
    SessionOptions options;
    options.camera.eye = {0.0f, 1.0f, 4.0f};
    options.camera.target = {0.0f, 0.0f, 0.0f};
    options.light.lights = {"0,0,1"};
    Camera camera;
    camera.eye = *options.camera.eye;
    const SessionOptions next = turntableOptions(options, camera, 1, 4);
    // What was on the left is now in front: the camera stands there.
    EXPECT_NEAR(next.camera.eye->x, -4.0f, 1e-6f);
    EXPECT_NEAR(next.camera.eye->y, 1.0f, 1e-6f);
    EXPECT_NEAR(next.camera.eye->z, 0.0f, 1e-6f);
    EXPECT_NEAR(next.light.rotationDegrees, -90.0f, 1e-6f);
    EXPECT_NEAR(lightFromText(next.light.lights[0]).direction.x, 1.0f, 1e-6f);
    EXPECT_EQ(turntableOptions(options, camera, 0, 4), options);
}

/// A triangle that falls by 3 m, between 0.5 and 2 s, and at once in another animation.
std::string writeFalling(const TestFolder& folder) {
    test::Bytes bytes;
    bytes.add({glm::vec3(0), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0)});
    bytes.add({0.5f, 2.0f}).add({glm::vec3(0), glm::vec3(0, -3, 0)});
    const auto animation = [](const char* name, int count) {
        return fmt::format(R"({{"name": "{}", "samplers": [{{"input": {}, "output": {}}}],
            "channels": [{{"sampler": 0, "target": {{"node": 0, "path": "translation"}}}}]}})",
                           name, count == 2 ? 1 : 3, count == 2 ? 2 : 4);
    };
    const auto accessor = [](const char* type, int count, int offset) {
        return fmt::format(R"({{"bufferView": 0, "componentType": 5126, "type": "{}",
            "count": {}, "byteOffset": {}}})",
                           type, count, offset);
    };
    const std::string path = folder.path("falling.gltf");
    std::ofstream(path) << R"({"asset": {"version": "2.0"}, "buffers": [)" << buffer(bytes)
                        << R"(], "bufferViews": [{"buffer": 0, "byteLength": 68}], "accessors": [)"
                        << accessor("VEC3", 3, 0) << ", " << accessor("SCALAR", 2, 36) << ", "
                        << accessor("VEC3", 2, 44) << ", " << accessor("SCALAR", 1, 36) << ", "
                        << accessor("VEC3", 1, 56)
                        << R"(], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
              "nodes": [{"mesh": 0}], "scenes": [{"nodes": [0]}], "animations": [)"
                        << animation("fall", 2) << ", " << animation("drop", 1) << "]}";
    return path;
}

TEST(AnimationSeconds, AreThoseToTheLastMoment) {
    const TestFolder folder;
    const std::string path = writeFalling(folder);
    EXPECT_EQ(animationSeconds(path, ""), 2.0);
    EXPECT_EQ(animationSeconds(path, "fall"), 2.0);
    EXPECT_EQ(animationSeconds(path, "1"), 0.5);
    EXPECT_EQ(animationSeconds(path, "fly"), 0.0);
    EXPECT_EQ(animationSeconds("sphere", ""), 0.0);
}

TEST(Series, GoesOnWithTheAnimationBeforeAStillCamera) {
    const TestFolder folder;
    SessionOptions options;
    options.subject.models = {writeFalling(folder)};
    options.light.ground = "lowest";
    options.light.faceSize = 8;
    const Series series({.fps = 4.0f}, options);
    ASSERT_EQ(series.count(), 8);
    Session session(series.first());
    const Camera camera = session.camera();
    const std::optional<float> ground = session.renderOptions().ground;
    for (int i = 0; i < series.count(); ++i) {
        session.apply(series.optionsOf(i, camera, ground));
        EXPECT_EQ(session.camera(), camera) << i;
        EXPECT_EQ(session.renderOptions().ground, 0.0f) << i;
        const float gone = std::max(0.25f * static_cast<float>(i) - 0.5f, 0.0f) / 1.5f;
        EXPECT_NEAR(session.scene().parts[0].mesh.positions[0].y, -3.0f * gone, 1e-5f) << i;
    }
}

TEST(Series, BeginsWhereItIsTold) {
    const TestFolder folder;
    SessionOptions options;
    options.subject.models = {writeFalling(folder)};
    options.subject.timeSeconds = 1.0f;
    const Series series({.fps = 10.0f}, options);
    EXPECT_EQ(series.count(), 10);
    EXPECT_EQ(series.optionsOf(3, {}, {}).subject.timeSeconds, 1.3f);
}

TEST(Series, BeginsTheAnimationAnewWhileTheModelTurns) {
    const TestFolder folder;
    SessionOptions options;
    options.subject.models = {writeFalling(folder)};
    const Series series({.turntable = 20, .fps = 4.0f}, options);
    EXPECT_EQ(series.count(), 20);
    EXPECT_EQ(series.optionsOf(9, {}, {}).subject.timeSeconds, 0.25f);
    EXPECT_NE(series.optionsOf(9, {}, {}).camera.eye, Camera{}.eye);
}

TEST(Series, RefusesWhatDoesNotMoveAndWhatWouldNotEnd) {
    SessionOptions options;
    options.subject.models = {"sphere"};
    const auto message = [&](const SeriesOptions& series) {
        return test::messageOf([&] { (void)Series(series, options); });
    };
    EXPECT_EQ(message({.fps = 25.0f}),
              "fps 25: the model has no animation (those of glTF are shown)");
    const TestFolder folder;
    options.subject.models = {writeFalling(folder)};
    EXPECT_EQ(message({.fps = 1e6f}), "fps 1000000: 2000000 pictures of 2 s; at most 1000000");
}

}  // namespace
}  // namespace tukor
