#include "tukor/scene/crease_normals.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "tukor/geometry/closedness.h"
#include "tukor/geometry/sphere.h"
#include "tukor/scene/finish_mesh.h"
#include "tukor/scene/interner.h"

namespace tukor {
namespace {

constexpr float kDegrees = std::numbers::pi_v<float> / 180.0f;

// A cube of two triangles a face; which diagonal is chosen at random.
Mesh cube(unsigned seed = 1) {
    std::mt19937 random(seed);
    Mesh mesh;
    for (unsigned i = 0; i < 8; ++i)
        mesh.positions.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    const glm::uvec4 faces[] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    for (const glm::uvec4 f : faces) {
        if (random() % 2) {
            mesh.triangles.emplace_back(f.x, f.y, f.z);
            mesh.triangles.emplace_back(f.x, f.z, f.w);
        } else {
            mesh.triangles.emplace_back(f.y, f.z, f.w);
            mesh.triangles.emplace_back(f.y, f.w, f.x);
        }
    }
    return mesh;
}

TEST(Interner, NumbersInOrderOfFirstOccurrence) {
    Interner<glm::vec3> places;
    EXPECT_EQ(places.add({1, 2, 3}), 0u);
    EXPECT_EQ(places.add({0.0f, 2, 3}), 1u);
    EXPECT_EQ(places.add({-0.0f, 2, 3}), 1u);
    for (int i = 0; i < 10000; ++i) EXPECT_EQ(places.add({i, -i, 7}), unsigned(i + 2));
    for (int i = 0; i < 10000; ++i) EXPECT_EQ(places.add({i, -i, 7}), unsigned(i + 2));
    EXPECT_EQ(places.keys().size(), 10002u);
}

TEST(CreaseNormals, OfACubeAreThoseOfItsFaces) {
    const Mesh mesh = withCreaseNormals(cube(), 30.0f * kDegrees);
    EXPECT_EQ(mesh.positions.size(), 24u);
    ASSERT_EQ(mesh.triangles.size(), 12u);
    for (const glm::uvec3 t : mesh.triangles) {
        const glm::vec3 a = mesh.positions[t.x];
        const glm::vec3 facet =
            glm::normalize(glm::cross(mesh.positions[t.y] - a, mesh.positions[t.z] - a));
        for (int i = 0; i < 3; ++i) EXPECT_LT(glm::length(mesh.normals[t[i]] - facet), 1e-6f);
    }
    EXPECT_TRUE(checkClosed(mesh).closed());
}

TEST(CreaseNormals, AreTheDiagonalsOfASmoothCubeHoweverItIsCut) {
    for (unsigned seed = 1; seed < 9; ++seed) {
        const Mesh mesh = withCreaseNormals(cube(seed), 100.0f * kDegrees);
        ASSERT_EQ(mesh.positions.size(), 8u);
        for (std::size_t i = 0; i < 8; ++i)
            EXPECT_LT(glm::length(mesh.normals[i] - glm::normalize(mesh.positions[i])), 1e-6f)
                << "seed " << seed;
    }
}

TEST(CreaseNormals, OfASphereAreRadialAfterWeldingASoup) {
    const Mesh sphere = makeSphere(20);
    Mesh soup;
    for (const glm::uvec3 t : sphere.triangles) {
        const auto base = static_cast<unsigned>(soup.positions.size());
        for (int i = 0; i < 3; ++i) soup.positions.push_back(sphere.positions[t[i]]);
        soup.triangles.emplace_back(base, base + 1, base + 2);
    }
    const Mesh mesh = withCreaseNormals(soup, 30.0f * kDegrees);
    EXPECT_EQ(mesh.positions.size(), sphere.positions.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        EXPECT_LT(glm::length(mesh.normals[i] - glm::normalize(mesh.positions[i])), 2e-3f);
    EXPECT_TRUE(checkClosed(mesh).closed());
}

// A prism of n sides has edges of 360 / n degrees.
TEST(CreaseNormals, TellCreasesByTheAngle) {
    for (const int sides : {11, 13}) {  // 32.7 and 27.7 degrees
        Mesh prism;
        for (int i = 0; i < sides; ++i) {
            const float a = 360.0f * kDegrees * float(i) / float(sides);
            prism.positions.emplace_back(std::cos(a), std::sin(a), 0.0f);
            prism.positions.emplace_back(std::cos(a), std::sin(a), 5.0f);
            const auto p = unsigned(2 * i), q = unsigned(2 * ((i + 1) % sides));
            prism.triangles.emplace_back(p, q, q + 1);
            prism.triangles.emplace_back(p, q + 1, p + 1);
        }
        const Mesh mesh = withCreaseNormals(prism, 30.0f * kDegrees);
        EXPECT_EQ(mesh.positions.size(), prism.positions.size() * (sides == 11 ? 2u : 1u));
    }
}

TEST(CreaseNormals, DropCollapsedTrianglesAndSurviveFlatOnes) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 1, 3}};
    const Mesh result = withCreaseNormals(mesh, 0.5f);
    ASSERT_EQ(result.triangles.size(), 1u);
    for (const glm::vec3 n : result.normals) EXPECT_NEAR(glm::length(n), 1.0f, 1e-6f);
    EXPECT_TRUE(withCreaseNormals({}, 0.5f).triangles.empty());
}

TEST(FinishedMesh, TurnsTrianglesRoundThatOpposeTheirNormals) {
    Mesh sphere = makeSphere(3);
    for (glm::uvec3& t : sphere.triangles) std::swap(t.x, t.y);
    Notes notes;
    const Mesh mesh = finishedMesh(sphere, 0.5f, "a.obj", "ball", notes);
    EXPECT_TRUE(checkClosed(mesh).closed());
    EXPECT_EQ(notes.sentences(), std::vector<std::string>{
                                     "triangles wound against their normals, turned round: ball"});
}

TEST(FinishedMesh, ComputesNormalsWhereOneHasNoDirection) {
    for (const float bad : {0.0f, std::nanf(""), HUGE_VALF}) {
        Mesh sphere = makeSphere(20);
        sphere.normals[5] = glm::vec3(bad);
        Notes notes;
        const Mesh mesh = finishedMesh(sphere, 0.5f, "a.obj", "ball", notes);
        for (std::size_t i = 0; i < mesh.positions.size(); ++i)
            EXPECT_NEAR(glm::dot(mesh.normals[i], glm::normalize(mesh.positions[i])), 1.0f, 1e-3f);
        EXPECT_EQ(notes.sentences().size(), 1u);
    }
}

}  // namespace
}  // namespace tukor
