#include "tukor/scene/camera.h"

#include <cmath>
#include <random>

#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "tukor/scene/scene.h"

namespace tukor {
namespace {

constexpr unsigned kSeed = 20261122;

Camera randomCamera(std::mt19937& random) {
    std::uniform_real_distribution<float> place(-3.0f, 3.0f), fov(0.2f, 2.0f);
    Camera camera;
    camera.eye = {place(random), place(random), place(random)};
    camera.target = {place(random), place(random), place(random)};
    camera.up = {place(random), place(random), place(random)};
    camera.verticalFov = fov(random);
    return camera;
}

TEST(Camera, LooksDownMinusZWithYUp) {
    const glm::mat4 matrix = cameraFromWorld(Camera{});
    EXPECT_EQ(matrix * glm::vec4(0, 0, 0, 1), glm::vec4(0, 0, -4, 1));
    EXPECT_EQ(matrix * glm::vec4(1, 2, 0, 1), glm::vec4(1, 2, -4, 1));
}

TEST(Camera, MatricesAreThoseOfGlm) {
    std::mt19937 random(kSeed);
    for (int i = 0; i < 100; ++i) {
        const Camera camera = randomCamera(random);
        const glm::mat4 view = cameraFromWorld(camera);
        const glm::mat4 expected = glm::lookAt(camera.eye, camera.target, camera.up);
        const ClipPlanes planes{0.3f, 30.0f};
        const glm::mat4 projection = clipFromCamera(camera, 1.7f, planes);
        const glm::mat4 perspective = glm::perspective(camera.verticalFov, 1.7f, 0.3f, 30.0f);
        for (int c = 0; c < 4; ++c)
            for (int r = 0; r < 4; ++r) {
                EXPECT_NEAR(view[c][r], expected[c][r], 2e-5f) << "camera " << i;
                EXPECT_NEAR(projection[c][r], perspective[c][r], 1e-5f) << "camera " << i;
            }
    }
}

TEST(Camera, RayDirMatrixInvertsProjectionViewAndEye) {
    std::mt19937 random(kSeed);
    for (int i = 0; i < 100; ++i) {
        const Camera camera = randomCamera(random);
        const ClipPlanes planes{0.3f, 30.0f};
        const glm::dmat4 e = glm::translate(glm::dmat4(1.0), glm::dvec3(camera.eye));
        const glm::dmat4 column = glm::inverse(glm::dmat4(clipFromCamera(camera, 1.5f, planes)) *
                                               glm::dmat4(cameraFromWorld(camera)) * e);
        // The lecture's matrices act on row vectors: each is the transpose, in the other order.
        const glm::dmat4 row =
            glm::inverse(glm::transpose(e) * glm::transpose(glm::dmat4(cameraFromWorld(camera))) *
                         glm::transpose(glm::dmat4(clipFromCamera(camera, 1.5f, planes))));
        const glm::dvec4 ndc(0.3, -0.7, 0.9, 1.0);
        EXPECT_LT(glm::length(ndc * row - column * ndc), 1e-9) << "camera " << i;
        const glm::dmat4 actual(rayDirMatrix(camera, 1.5f, planes));
        for (int c = 0; c < 4; ++c)
            for (int r = 0; r < 4; ++r) {  // float rounding times |eye| < 6 and 1/near = 3.3
                EXPECT_NEAR(actual[c][r], column[c][r], 1e-4) << "camera " << i;
                EXPECT_NEAR(actual[c][r], row[r][c], 1e-4) << "camera " << i;
            }
    }
}

TEST(Camera, RayDirMatrixAgreesWithRayDirectionAtPixelCentres) {
    std::mt19937 random(kSeed);
    constexpr int kWidth = 16, kHeight = 9;
    for (int i = 0; i < 50; ++i) {
        const Camera camera = randomCamera(random);
        const glm::mat4 matrix = rayDirMatrix(camera, float(kWidth) / float(kHeight));
        for (int row = 0; row < kHeight; ++row)
            for (int column = 0; column < kWidth; ++column) {
                const float x = float(column) + 0.5f, y = float(row) + 0.5f;
                const glm::vec4 ndc(2.0f * x / kWidth - 1.0f, 1.0f - 2.0f * y / kHeight, 0.999f, 1);
                const glm::vec4 d = matrix * ndc;
                const glm::vec3 expected = rayDirection(camera, kWidth, kHeight, x, y);
                EXPECT_LT(glm::length(glm::vec3(d) - expected), 1e-6f * glm::length(expected));
                EXPECT_GT(d.w, 0.0f) << "interpolation relies on one sign of w";
            }
    }
}

TEST(Camera, SeesAPointWhereItsRayGoes) {
    std::mt19937 random(kSeed);
    for (int i = 0; i < 100; ++i) {
        const Camera camera = randomCamera(random);
        const glm::vec3 point = camera.eye + 2.5f * rayDirection(camera, 640, 360, 100.5f, 300.5f);
        const glm::vec4 clip = clipFromCamera(camera, 640.0f / 360.0f) * cameraFromWorld(camera) *
                               glm::vec4(point, 1.0f);
        EXPECT_NEAR((clip.x / clip.w + 1.0f) * 320.0f, 100.5f, 0.01f) << "camera " << i;
        EXPECT_NEAR((1.0f - clip.y / clip.w) * 180.0f, 300.5f, 0.01f) << "camera " << i;
    }
}

TEST(Camera, HasAxesWhereUpIsAlongTheView) {
    Camera camera;
    camera.eye = {0, 5, 0};
    const CameraAxes axes = axesOf(camera);
    EXPECT_NEAR(glm::length(axes.right), 1.0f, 1e-6f);
    EXPECT_NEAR(glm::dot(axes.right, axes.forward), 0.0f, 1e-6f);
}

TEST(ClipPlanes, EncloseTheBoxFromAnywhere) {
    std::mt19937 random(kSeed);
    const Bounds box{{-1, -2, 0}, {2, 1, 0.5f}};
    for (int i = 0; i < 200; ++i) {
        Camera camera = randomCamera(random);
        if (i % 2 == 0) camera.eye *= 1000.0f;
        const ClipPlanes planes = clipPlanesFor(camera, box);
        ASSERT_GT(planes.nearDistance, 0.0f);
        ASSERT_LT(planes.nearDistance, planes.farDistance);
        for (int corner = 0; corner < 8; ++corner) {
            const glm::vec3 p(corner & 1 ? box.most.x : box.least.x,
                              corner & 2 ? box.most.y : box.least.y,
                              corner & 4 ? box.most.z : box.least.z);
            const float depth = glm::dot(p - camera.eye, axesOf(camera).forward);
            EXPECT_LT(depth, planes.farDistance) << "camera " << i;
            if (depth > 1e-3f * planes.farDistance) {
                EXPECT_GT(depth, planes.nearDistance) << "camera " << i;
            }
        }
    }
}

TEST(ClipPlanes, ExistForAPointAndForNothing) {
    const ClipPlanes none = clipPlanesFor({}, {});
    EXPECT_LT(none.nearDistance, none.farDistance);
    const ClipPlanes point = clipPlanesFor({}, {{0, 0, 0}, {0, 0, 0}});
    EXPECT_LT(point.nearDistance, 4.0f);
    EXPECT_GT(point.farDistance, 4.0f);
}

TEST(FramingCamera, ShowsTheWholeSceneInBothDirections) {
    Scene scene;
    scene.parts.emplace_back();
    scene.parts[0].mesh.positions = {{-3, -1, -2}, {5, 1, 2}, {0, 7, 0}};
    for (const float aspect : {0.4f, 1.0f, 2.5f}) {
        const Camera camera = framingCamera(scene, aspect);
        for (const glm::vec3 p : scene.parts[0].mesh.positions) {
            const glm::vec4 clip =
                clipFromCamera(camera, aspect) * cameraFromWorld(camera) * glm::vec4(p, 1.0f);
            EXPECT_LE(std::abs(clip.x / clip.w), 1.0f);
            EXPECT_LE(std::abs(clip.y / clip.w), 1.0f);
        }
    }
}

}  // namespace
}  // namespace tukor
