#include "tukor/geometry/shapes.h"

#include <cmath>
#include <map>
#include <numbers>

#include <gtest/gtest.h>

#include "tukor/geometry/closedness.h"
#include "tukor/geometry/sphere.h"

namespace tukor {
namespace {

class EveryShape : public testing::TestWithParam<std::string_view> {};

TEST_P(EveryShape, IsASolidWithUnitNormalsThatAgreeWithItsWinding) {
    const auto parts = makeShape(GetParam());
    ASSERT_TRUE(parts.has_value());
    ASSERT_FALSE(parts->empty());
    for (const ShapePart& part : *parts) {
        SCOPED_TRACE(part.name);
        const Mesh& mesh = part.mesh;
        ASSERT_EQ(mesh.positions.size(), mesh.normals.size());
        ASSERT_FALSE(mesh.triangles.empty());
        for (glm::uvec3 t : mesh.triangles)
            for (int i = 0; i < 3; ++i) ASSERT_LT(t[i], mesh.positions.size());
        const ClosednessReport report = checkClosed(mesh);
        EXPECT_EQ(report.openEdges, 0);
        EXPECT_EQ(report.nonManifoldEdges, 0);
        EXPECT_EQ(report.degenerate, 0);
        EXPECT_EQ(report.againstNormals, 0);
        EXPECT_GT(report.volume, 0.0);
        EXPECT_EQ(warningOf(report), "");
        for (glm::vec3 normal : mesh.normals) ASSERT_NEAR(glm::length(normal), 1.0f, 1e-6f);
    }
}

// Twice the area over the longest edge squared: 1.15 when equilateral, 0 for a needle.
TEST_P(EveryShape, HasNoNeedles) {
    const auto parts = makeShape(GetParam());
    ASSERT_TRUE(parts.has_value());
    for (const ShapePart& part : *parts) {
        SCOPED_TRACE(part.name);
        for (glm::uvec3 t : part.mesh.triangles) {
            const glm::dvec3 a(part.mesh.positions[t.x]), b(part.mesh.positions[t.y]),
                c(part.mesh.positions[t.z]);
            const double longest =
                std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
            ASSERT_GT(glm::length(glm::cross(b - a, c - a)) / (longest * longest), 1e-3);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Shapes, EveryShape, testing::ValuesIn(shapeNames()),
                         [](const auto& parameter) {
                             std::string name(parameter.param);
                             std::erase(name, '-');
                             return name;
                         });

TEST(Shapes, AnUnknownNameHasNone) {
    EXPECT_FALSE(makeShape("cone of cold").has_value());
    EXPECT_FALSE(makeShape("").has_value());
}

TEST(Sphere, HasTheAreaOfTheUnitSphere) {
    const Mesh mesh = makeSphere(65);
    EXPECT_GE(mesh.triangles.size(), 82000u);
    double area = 0.0, least = 1e9, most = 0.0;
    for (glm::uvec3 t : mesh.triangles) {
        const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
        const double size = 0.5 * glm::length(glm::cross(b - a, c - a));
        area += size;
        least = std::min(least, size);
        most = std::max(most, size);
    }
    EXPECT_NEAR(area, 4.0 * std::numbers::pi, 1e-5);  // 84,500 triangles of rounded floats
    EXPECT_LT(most / least, 1.5);                     // evenly sized
    const ClosednessReport report = checkClosed(mesh);
    EXPECT_EQ(report.eulerCharacteristic, 2);
    EXPECT_NEAR(report.volume, 4.0 / 3.0 * std::numbers::pi, 2e-4);
}

TEST(Sphere, HasTheNormalsOfTheTrueSphere) {
    const Mesh mesh = makeSphere(8);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        ASSERT_LT(glm::distance(glm::normalize(mesh.positions[i]), mesh.normals[i]), 2e-7f);
}

TEST(TorusKnot, IsATorusToTopologists) {
    const ClosednessReport report = checkClosed(makeShape("torus-knot")->front().mesh);
    EXPECT_EQ(report.eulerCharacteristic, 0);
}

// Pappus: the volume of a tube is its cross section times the length of its centre line.
TEST(TorusKnot, HasTheVolumeOfItsTube) {
    const double radius = 0.18, minor = (1.0 - radius) / 3.0;
    double length = 0.0;
    const int steps = 100000;
    for (int i = 0; i < steps; ++i) {
        const double t = 2.0 * std::numbers::pi * (i + 0.5) / steps;
        const double around = 2.0 * (2.0 + std::cos(3.0 * t)) * minor;
        length += std::hypot(around, 3.0 * minor) * 2.0 * std::numbers::pi / steps;
    }
    const double volume = std::numbers::pi * radius * radius * length;
    EXPECT_NEAR(checkClosed(makeShape("torus-knot")->front().mesh).volume, volume, 2e-3 * volume);
}

}  // namespace
}  // namespace tukor
