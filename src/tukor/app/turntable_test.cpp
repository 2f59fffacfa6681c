#include "tukor/app/turntable.h"

#include <gtest/gtest.h>

#include "tukor/app/picture.h"
#include "tukor/app/session.h"

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

}  // namespace
}  // namespace tukor
