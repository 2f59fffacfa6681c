#include "tukor/app/pick.h"

#include <gtest/gtest.h>

namespace tukor {
namespace {

Part triangleAt(float z) {
    Part part;
    part.mesh.positions = {{-1, -1, z}, {1, -1, z}, {0, 1, z}};
    part.mesh.normals.assign(3, {0, 0, 1});
    part.mesh.triangles = {{0, 1, 2}};
    return part;
}

TEST(Pick, FindsTheNearestOfTwo) {
    Scene scene;
    scene.parts = {triangleAt(-1), triangleAt(1)};
    const auto fromFront = pick(scene, {0, 0, 4}, {0, 0, -2});
    ASSERT_TRUE(fromFront);
    EXPECT_EQ(fromFront->part, 1u);
    EXPECT_NEAR(fromFront->position.z, 1.0f, 1e-6f);
    const auto fromBehind = pick(scene, {0, 0, -4}, {0, 0, 1});
    ASSERT_TRUE(fromBehind);
    EXPECT_EQ(fromBehind->part, 0u);
}

TEST(Pick, MissesWhatLiesBesideOrBehind) {
    Scene scene;
    scene.parts = {triangleAt(0)};
    EXPECT_FALSE(pick(scene, {3, 0, 4}, {0, 0, -1}));
    EXPECT_FALSE(pick(scene, {0, 0, 4}, {0, 0, 1}));
    EXPECT_FALSE(pick({}, {0, 0, 4}, {0, 0, -1}));
}

}  // namespace
}  // namespace tukor
