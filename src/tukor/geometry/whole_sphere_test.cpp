#include "tukor/geometry/whole_sphere.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tukor/geometry/shapes.h"
#include "tukor/geometry/sphere.h"
#include "tukor/geometry/sphere_hit.h"

namespace tukor {
namespace {

using namespace tukor::geometry;

Mesh placed(Mesh mesh, glm::vec3 centre, glm::vec3 scale) {
    for (glm::vec3& p : mesh.positions) p = centre + scale * p;
    for (glm::vec3& n : mesh.normals) n = glm::normalize(n / scale);
    return mesh;
}

TEST(WholeSphere, IsFoundWithItsPlaceAndSize) {
    const auto sphere = wholeSphere(placed(makeSphere(32), {3, -2, 1}, glm::vec3(0.25f)));
    ASSERT_TRUE(sphere);
    EXPECT_NEAR(glm::distance(sphere->centre, glm::vec3(3, -2, 1)), 0.0f, 1e-6f);
    EXPECT_NEAR(sphere->radius, 0.25f, 1e-6f);
}

TEST(WholeSphere, IsNothingElse) {
    const Mesh ball = makeSphere(32);
    EXPECT_FALSE(wholeSphere(makeSphere(4))) << "too coarse: its outline shows corners";
    EXPECT_FALSE(wholeSphere(placed(ball, {0, 0, 0}, {1, 1, 1.01f}))) << "an ellipsoid";
    Mesh faceted = ball;
    for (glm::uvec3 t : faceted.triangles) faceted.normals[t.x] = faceted.normals[t.y];
    EXPECT_FALSE(wholeSphere(faceted));
    Mesh open = ball;
    open.triangles.pop_back();
    EXPECT_FALSE(wholeSphere(open));
    Mesh inward = ball;
    for (glm::uvec3& t : inward.triangles) std::swap(t.y, t.z);
    EXPECT_FALSE(wholeSphere(inward));
    Mesh dented = ball;
    dented.positions[100] *= 0.99f;
    EXPECT_FALSE(wholeSphere(dented));
    Mesh bad = ball;
    bad.positions[5].x = std::nanf("");
    EXPECT_FALSE(wholeSphere(bad));
    EXPECT_FALSE(wholeSphere(Mesh{}));
    for (const std::string_view name : shapeNames()) {
        const std::vector<ShapePart> parts = makeShape(name).value();
        for (const ShapePart& part : parts) {
            EXPECT_EQ(wholeSphere(part.mesh).has_value(), name == "sphere") << name;
        }
    }
}

TEST(SphereHit, FindsBothEndsOfAChord) {
    const glm::vec3 centre(1, 2, 3);
    EXPECT_NEAR(sphereDistance({1, 2, 8}, {0, 0, -1}, centre, 2.0f, 0.0f, false), 3.0f, 1e-6f);
    EXPECT_NEAR(sphereDistance({1, 2, 8}, {0, 0, -1}, centre, 2.0f, 3.5f, false), 7.0f, 1e-6f);
    EXPECT_NEAR(sphereDistance({1, 2, 3}, {0, 1, 0}, centre, 2.0f, 0.0f, false), 2.0f, 1e-6f);
    EXPECT_EQ(sphereDistance({1, 2, 8}, {0, 0, 1}, centre, 2.0f, 0.0f, false), kSphereMissed);
    EXPECT_EQ(sphereDistance({1, 5, 8}, {0, 0, -1}, centre, 2.0f, 0.0f, false), kSphereMissed);
}

TEST(SphereHit, ARayThatLeavesMeetsOnlyTheFarSide) {
    const glm::vec3 centre(1, 2, 3);
    for (int i = 0; i < 2000; ++i) {
        const auto a = static_cast<float>(i) * 2.399963f;
        const float z = 1.0f - (static_cast<float>(i) + 0.5f) / 1000.0f;
        const float r = std::sqrt(1.0f - z * z);
        const glm::vec3 out(r * std::cos(a), r * std::sin(a), z);
        const glm::vec3 start = centre + 2.0f * out;
        for (const float slope : {1e-3f, 0.1f, 0.9f}) {
            const glm::vec3 along = glm::normalize(glm::cross(out, glm::vec3(0.3f, 0.5f, 0.8f)));
            const glm::vec3 inwards = std::sqrt(1.0f - slope * slope) * along - slope * out;
            const float t = sphereDistance(start, inwards, centre, 2.0f, 0.0f, true);
            EXPECT_NEAR(t, 4.0f * slope, 2e-6f);
            EXPECT_EQ(sphereDistance(start, inwards + 2.0f * slope * out, centre, 2.0f, 0.0f, true),
                      kSphereMissed);
            const SpherePoint p = spherePoint(start, inwards, t, centre, 2.0f);
            EXPECT_NEAR(glm::distance(p.position, centre), 2.0f, 1e-6f);
            EXPECT_NEAR(glm::dot(glm::normalize(glm::cross(p.e1, p.e2)), p.normal), 1.0f, 1e-6f);
        }
    }
}

}  // namespace
}  // namespace tukor
