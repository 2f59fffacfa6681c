#include "tukor/scene/placement.h"

#include <gtest/gtest.h>

#include "tukor/geometry/shapes.h"

namespace tukor {
namespace {

TEST(Placement, SetsWhatStandsAlongZUpright) {
    Scene scene;
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1024, 0, 0}, {0, 0, 2048}};
    mesh.normals = {{0, -1, 0}, {0, -1, 0}, {0, -1, 0}};
    mesh.triangles = {{0, 1, 2}};
    mesh.tangents = {{0, 0, 1, -1}, {0, 0, 1, -1}, {0, 0, 1, -1}};
    scene.parts.push_back({"part", "", {}, mesh});
    scene.cameras.push_back({"front", {.eye = {0, -3072, 0}, .target = {}, .up = {0, 0, 1}}});
    Light lamp;
    lamp.kind = LightKind::point;
    lamp.position = {0, 0, 1024};
    lamp.direction = {0, 0, -1};
    lamp.range = 512;
    scene.lights = {lamp};
    place(scene, UpAxis::z, 1.0f / 1024.0f);
    const Mesh& placed = scene.parts[0].mesh;
    EXPECT_EQ(placed.positions[1], glm::vec3(1, 0, 0));
    EXPECT_EQ(placed.positions[2], glm::vec3(0, 2, 0));
    EXPECT_EQ(placed.normals[0], glm::vec3(0, 0, 1));  // its front faces the usual camera
    EXPECT_EQ(placed.tangents[0], glm::vec4(0, 1, 0, -1));
    EXPECT_EQ(scene.cameras[0].camera.eye, glm::vec3(0, 0, 3));
    EXPECT_EQ(scene.cameras[0].camera.up, glm::vec3(0, 1, 0));
    EXPECT_EQ(scene.lights[0].position, glm::vec3(0, 1, 0));
    EXPECT_EQ(scene.lights[0].direction, glm::vec3(0, -1, 0));
    EXPECT_FLOAT_EQ(scene.lights[0].range, 0.5f);
    // At 1 / 1024 of the distance, the same irradiance.
    EXPECT_FLOAT_EQ(scene.lights[0].intensity.x, 1.0f / 1048576.0f);
}

TEST(Placement, LeavesWhatIsAsItShouldBe) {
    Scene scene;
    scene.parts.push_back({"sphere", "", {}, (*makeShape("sphere"))[0].mesh});
    const Mesh before = scene.parts[0].mesh;
    place(scene, UpAxis::y, 1.0f);
    EXPECT_EQ(scene.parts[0].mesh.positions, before.positions);
    EXPECT_EQ(scene.parts[0].mesh.normals, before.normals);
}

}  // namespace
}  // namespace tukor
