// What the built-in solids are beyond being closed: facets, volumes, overlaps.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <tuple>

#include <gtest/gtest.h>

#include "tukor/geometry/brilliant.h"
#include "tukor/geometry/closedness.h"
#include "tukor/geometry/revolution.h"
#include "tukor/geometry/shapes.h"
#include "tukor/geometry/teapot.h"
#include "tukor/geometry/tumbler.h"
#include "tukor/geometry/water_surface.h"

namespace tukor {
namespace {

using glm::dvec2, glm::dvec3;

dvec3 faceNormal(const Mesh& mesh, glm::uvec3 t) {
    const dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
    return glm::normalize(glm::cross(b - a, c - a));
}

// The largest angle between a triangle and its corners' normals.
double largestNormalError(const Mesh& mesh) {
    double largest = 0.0;
    for (glm::uvec3 t : mesh.triangles)
        for (int i = 0; i < 3; ++i) {
            const dvec3 face = faceNormal(mesh, t), normal(mesh.normals[t[i]]);
            largest = std::max(
                largest, std::atan2(glm::length(glm::cross(face, normal)), glm::dot(face, normal)));
        }
    return largest;
}

TEST(Brilliant, HasFiftySevenFacetsAndAGirdle) {
    const BrilliantOptions options;
    std::set<std::tuple<float, float, float>> normals;
    for (glm::vec3 n : makeBrilliant().normals) normals.insert({n.x, n.y, n.z});
    // No two facets are parallel and face the same way, but each half is a plane of its own.
    EXPECT_EQ(normals.size(), 57u + options.girdleFacets);
}

TEST(Brilliant, HasFlatFacets) {
    EXPECT_LT(largestNormalError(makeBrilliant()), 1e-5);  // a girdle edge of 0.03 in floats
}

TEST(Brilliant, HasTheAnglesOfTheCut) {
    const Mesh mesh = makeBrilliant();
    std::map<int, int> facetsAt;  // tilt in hundredths of a degree, of triangles
    for (glm::vec3 n : mesh.normals)
        ++facetsAt[static_cast<int>(
            std::lround(100.0 * std::acos(n.y) * 180.0 / std::numbers::pi))];
    EXPECT_EQ(facetsAt[0], 8);                 // the table's corners
    EXPECT_EQ(facetsAt[3450], 8 * 4);          // bezels
    EXPECT_EQ(facetsAt[18000 - 4075], 8 * 4);  // mains
    const Bounds bounds = boundsOf(mesh);
    EXPECT_NEAR(bounds.most.x, 1.0f, 1e-6f);
    EXPECT_NEAR(bounds.most.y, -bounds.least.y, 1e-6f);
}

TEST(Brilliant, IsConvex) {
    const Mesh mesh = makeBrilliant();
    for (glm::uvec3 t : mesh.triangles)
        for (glm::vec3 p : mesh.positions)
            ASSERT_LT(glm::dot(faceNormal(mesh, t), dvec3(p) - dvec3(mesh.positions[t.x])), 1e-6);
}

TEST(Teapot, PartsAreBalls) {
    const Teapot pot = makeTeapot();
    EXPECT_EQ(checkClosed(pot.body).eulerCharacteristic, 2);
    EXPECT_EQ(checkClosed(pot.spout).eulerCharacteristic, 2);
    EXPECT_EQ(checkClosed(pot.handle).eulerCharacteristic, 2);
}

TEST(Teapot, HasSmoothNormalsAwayFromItsCreases) {
    const Teapot pot = makeTeapot();
    EXPECT_LT(largestNormalError(pot.body), 0.35);    // the tight curve of the rim
    EXPECT_LT(largestNormalError(pot.handle), 0.35);  // and the handle's rounded edges
    EXPECT_LT(largestNormalError(pot.spout), 0.35);
}

TEST(Teapot, StandsUprightOnItsAxis) {
    const Mesh body = makeTeapot().body;
    const Bounds bounds = boundsOf(body);
    EXPECT_NEAR(bounds.most.x, 2.0f / 3.2625f, 1e-3f);
    EXPECT_NEAR(bounds.most.x, -bounds.least.x, 1e-6f);
    for (std::size_t i = 0; i < body.positions.size(); ++i)
        if (body.positions[i].y == bounds.most.y) {
            EXPECT_EQ(body.positions[i].x, 0.0f);
            EXPECT_NEAR(body.normals[i].y, 1.0f, 1e-6f);  // the knob's pole, a degenerate patch
        }
}

TEST(Teapot, SpoutAndHandleEndInsideTheBody) {
    // The body is a surface of revolution to 0.1 %: its outline in (radius, height).
    const Teapot pot = makeTeapot();
    const auto band = [](float y) { return static_cast<int>(std::lround(50.0f * (y + 1.0f))); };
    std::map<int, float> bodyRadius;
    for (glm::vec3 p : pot.body.positions)
        for (int k = -1; k <= 1; ++k) {
            float& radius = bodyRadius[band(p.y) + k];
            radius = std::max(radius, std::hypot(p.x, p.z));
        }
    const auto insideOf = [&](const Mesh& mesh) {
        int inside = 0;
        for (glm::uvec3 t : mesh.triangles) {
            const glm::vec3 p = mesh.positions[t.x];
            if (std::hypot(p.x, p.z) < 0.97f * bodyRadius[band(p.y)]) ++inside;
        }
        return inside;
    };
    EXPECT_GT(insideOf(pot.spout), 48);   // its cap alone has 48 triangles
    EXPECT_GT(insideOf(pot.handle), 96);  // two caps
}

TEST(Tumbler, InterfacesAreThoseOfTheOverlappingSolids) {
    const Tumbler solids = makeTumbler();
    const auto interfaces = makeTumblerInterfaces();
    ASSERT_EQ(interfaces.size(), 3u);
    const auto trianglesOf = [](const Mesh& mesh) {
        std::set<std::array<float, 18>> all;
        for (glm::uvec3 t : mesh.triangles) {
            std::array<float, 18> values{};
            for (int i = 0; i < 3; ++i)
                for (int k = 0; k < 3; ++k) {
                    values[6 * i + k] = mesh.positions[t[i]][k];
                    values[6 * i + 3 + k] = mesh.normals[t[i]][k];
                }
            all.insert(values);
        }
        return all;
    };
    const auto glass = trianglesOf(solids.glass), water = trianglesOf(solids.water);
    std::size_t ofGlass = 0;
    for (const MediumInterface& surface : interfaces)
        for (const auto& triangle : trianglesOf(surface.mesh)) {
            EXPECT_TRUE((surface.back == "glass" ? glass : water).contains(triangle));
            ofGlass += surface.back == "glass" ? 1 : 0;
        }
    EXPECT_EQ(ofGlass, glass.size());
}

TEST(Tumbler, WaterReachesIntoTheWallButNotThroughIt) {
    const Tumbler solids = makeTumbler();
    const Bounds glass = boundsOf(solids.glass), water = boundsOf(solids.water);
    EXPECT_GT(water.least.y, glass.least.y + 0.1f);
    EXPECT_LT(water.most.y, glass.most.y - 0.1f);
    for (glm::vec3 p : solids.water.positions) {
        const float wall = 0.58f + 0.08f * (p.y + 1.0f);  // outer radius at that height
        ASSERT_LT(std::hypot(p.x, p.z), wall - 0.02f);
    }
}

TEST(WineGlass, IsABall) {
    EXPECT_EQ(checkClosed(makeWineGlass()).eulerCharacteristic, 2);
}

TEST(WaterSurface, HasTheNormalsOfItsSlopes) {
    const int steps = 180;
    const Mesh mesh = makeWaterSurface(steps);
    for (int row = 1; row < steps; ++row)
        for (int column = 1; column < steps; ++column) {
            const auto at = [&](int r, int c) {
                return dvec3(mesh.positions[r * (steps + 1) + c]);
            };
            const dvec3 across = at(row, column + 1) - at(row, column - 1);
            const dvec3 along = at(row + 1, column) - at(row - 1, column);
            const dvec3 normal = glm::normalize(glm::cross(along, across));
            // Central differences of waves of 52 radians a metre, steps of 11 mm: (kh)^2 / 6 of the
            // slope 0.3.
            ASSERT_LT(glm::distance(normal, dvec3(mesh.normals[row * (steps + 1) + column])), 0.02);
        }
}

TEST(Box, HasItsVolume) {
    const Mesh box = makeBox(glm::vec3(-1, 0, 2), glm::vec3(1, 3, 6));
    EXPECT_NEAR(checkClosed(box).volume, 24.0, 1e-5);
    EXPECT_EQ(checkClosed(box).eulerCharacteristic, 2);
    EXPECT_LT(largestNormalError(box), 1e-6);
}

TEST(Revolution, TurnsAnOutlineWithFilletsIntoASolid) {
    // A cylinder of radius 2 and height 1 with edges rounded by 0.25.
    const OutlineCorner outline[] = {
        {dvec2(0, 0)}, {dvec2(2, 0), 0.25}, {dvec2(2, 1), 0.25}, {dvec2(0, 1)}};
    const Mesh mesh = revolve(profileFromOutline(outline, 32, 2), 512);
    const ClosednessReport report = checkClosed(mesh);
    EXPECT_TRUE(report.closed());
    EXPECT_EQ(report.againstNormals, 0);
    // What the fillets take away: Pappus, with the centroid of a square corner less a quarter disc.
    const double area = 0.0625 * (1.0 - std::numbers::pi / 4.0);
    const double fromCorner =
        0.25 - 0.25 * (0.5 - 1.0 / 3.0) / (1.0 - std::numbers::pi / 4.0);  // centroid to the edge
    const double volume =
        std::numbers::pi * 4.0 - 2.0 * area * 2.0 * std::numbers::pi * (2.0 - fromCorner);
    EXPECT_NEAR(report.volume, volume, 2e-3);
    EXPECT_LT(largestNormalError(mesh), 0.04);  // half a step of the fillet
}

}  // namespace
}  // namespace tukor
