#include "tukor/geometry/closedness.h"

#include <utility>

#include <gtest/gtest.h>

#include "tukor/geometry/sphere.h"

namespace tukor {
namespace {

TEST(Closedness, CountsTheEdgesOfAHole) {
    Mesh mesh = makeSphere(4);
    mesh.triangles.pop_back();
    const ClosednessReport report = checkClosed(mesh);
    EXPECT_EQ(report.openEdges, 3);
    EXPECT_FALSE(report.closed());
    EXPECT_EQ(warningOf(report),
              "not closed: 3 open edges; glass and water need closed surfaces: fill the holes and "
              "merge doubled vertices, or give it a metal");
}

TEST(Closedness, SeesASurfaceTurnedInsideOut) {
    Mesh mesh = makeSphere(4);
    for (glm::uvec3& t : mesh.triangles) std::swap(t.y, t.z);
    const ClosednessReport report = checkClosed(mesh);
    EXPECT_EQ(report.openEdges, 0);
    EXPECT_EQ(report.againstNormals, 3 * 320);
    EXPECT_FALSE(report.closed());
    EXPECT_EQ(warningOf(report),
              "inside out: its triangles run clockwise seen from outside; flip its normals");
}

TEST(Closedness, SeesOneTriangleTurnedRound) {
    Mesh mesh = makeSphere(4);
    std::swap(mesh.triangles[7].y, mesh.triangles[7].z);
    const ClosednessReport report = checkClosed(mesh);
    EXPECT_EQ(report.nonManifoldEdges, 3);
    EXPECT_EQ(report.openEdges, 6);  // the turned ones, and those of the neighbours
}

TEST(Closedness, WeldsVerticesAtTheSamePlace) {
    const Mesh smooth = makeSphere(3);
    Mesh flat;  // every corner its own vertex
    for (glm::uvec3 t : smooth.triangles) {
        const auto next = static_cast<unsigned>(flat.positions.size());
        for (int i = 0; i < 3; ++i) {
            flat.positions.push_back(smooth.positions[t[i]]);
            flat.normals.push_back(smooth.normals[t[i]]);
        }
        flat.triangles.emplace_back(next, next + 1, next + 2);
    }
    EXPECT_TRUE(checkClosed(flat).closed());
    EXPECT_EQ(checkClosed(flat).eulerCharacteristic, 2);
}

TEST(Closedness, CountsTrianglesWithoutArea) {
    Mesh mesh = makeSphere(2);
    mesh.triangles.emplace_back(0, 1, 1);
    EXPECT_EQ(checkClosed(mesh).degenerate, 1);
    EXPECT_TRUE(checkClosed(mesh).closed());
}

TEST(Closedness, OfNothingIsNotASolid) {
    EXPECT_FALSE(checkClosed(Mesh{}).closed());
}

}  // namespace
}  // namespace tukor
