#include "tukor/geometry/bvh.h"

#include <atomic>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tukor/base/error.h"
#include "tukor/base/parallel.h"
#include "tukor/geometry/bvh_binary.h"
#include "tukor/geometry/bvh_traversal.h"
#include "tukor/geometry/shapes.h"
#include "tukor/geometry/sphere.h"

namespace tukor {
namespace {

using geometry::BvhHit;

constexpr float kFar = 1e30f;

BvhHit nearest(const Bvh& bvh, glm::vec3 origin, glm::vec3 direction, int skip = -1) {
    return geometry::nearestBvhHit(bvh.view(), origin, direction, 0.0f, kFar, skip);
}

// Every triangle in turn, by the same test.
BvhHit nearestOfAll(const Bvh& bvh, glm::vec3 origin, glm::vec3 direction, int skip = -1) {
    BvhHit hit{kFar, 0.0f, 0.0f, -1, -1.0f};
    const geometry::BvhRay ray = geometry::bvhRay(origin, direction);
    for (int i = 0; i < bvh.triangleCount(); ++i)
        if (i != skip) geometry::bvhTriangle(bvh.view(), i, ray, 0.0f, hit);
    return hit;
}

std::vector<const Mesh*> meshesOf(const std::vector<ShapePart>& parts) {
    std::vector<const Mesh*> meshes;
    for (const ShapePart& part : parts) meshes.push_back(&part.mesh);
    return meshes;
}

Bvh bvhOf(const Mesh& mesh) {
    const Mesh* part = &mesh;
    return buildBvh({&part, 1});
}

class Rays {
public:
    explicit Rays(unsigned seed) : random_(seed) {}

    float between(float least, float most) {
        return std::uniform_real_distribution<float>(least, most)(random_);
    }
    glm::vec3 inBox(float size) {
        return glm::vec3(between(-size, size), between(-size, size), between(-size, size));
    }
    glm::vec3 direction() {
        for (;;) {
            const glm::vec3 d = inBox(1.0f);
            if (glm::dot(d, d) <= 1.0f && glm::dot(d, d) > 1e-4f) return glm::normalize(d);
        }
    }

private:
    std::mt19937 random_;
};

// Triangles of all sizes and shapes, some without area, some equal.
Mesh soup(unsigned seed, int count, float scale) {
    Rays random(seed);
    Mesh mesh;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 centre = random.inBox(1.0f);
        const float size = std::exp(random.between(-6.0f, 0.0f));
        for (int corner = 0; corner < 3; ++corner) {
            glm::vec3 p = centre + random.inBox(size);
            if (i % 7 == 0) p.y = 0.25f;                                    // flat boxes
            if (i % 50 == 0) p = centre;                                    // points
            if (i % 11 == 0 && i > 11) p = mesh.positions[corner] / scale;  // the first one again
            mesh.positions.push_back(scale * p);
            mesh.normals.emplace_back(0.0f, 1.0f, 0.0f);
        }
        mesh.triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
    }
    return mesh;
}

void expectSame(const BvhHit& a, const BvhHit& b) {
    ASSERT_EQ(a.triangle, b.triangle);
    ASSERT_EQ(a.t, b.t);
    ASSERT_EQ(a.u, b.u);
    ASSERT_EQ(a.v, b.v);
}

TEST(Bvh, FindsExactlyWhatTryingEveryTriangleFinds) {
    for (const float scale : {1.0f, 1e-6f, 1e6f}) {
        const Mesh mesh = soup(7, 1500, scale);
        const Bvh bvh = bvhOf(mesh);
        Rays random(8);
        for (int i = 0; i < 3000; ++i) {
            SCOPED_TRACE(testing::Message() << "scale " << scale << " ray " << i);
            glm::vec3 origin = random.inBox(i % 3 == 0 ? 1.0f : i % 3 == 1 ? 10.0f : 1000.0f);
            glm::vec3 direction =
                i % 3 == 0 ? random.direction() : glm::normalize(random.inBox(1.0f) - origin);
            if (i % 5 == 0) direction[i % 3] = 0.0f;  // along an axis's planes
            if (i % 25 == 0) direction = glm::vec3(0.0f, i % 2 == 0 ? 1.0f : -1.0f, 0.0f);
            if (i % 10 == 0) origin = mesh.positions[i % mesh.positions.size()] / scale;
            const int skip = i % 4 == 0 ? i % bvh.triangleCount() : -1;
            expectSame(nearest(bvh, scale * origin, direction, skip),
                       nearestOfAll(bvh, scale * origin, direction, skip));
        }
    }
}

TEST(Bvh, OfEquallyNearTrianglesTheFirstWins) {
    Mesh mesh;
    const glm::vec3 corners[] = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
    for (unsigned copy = 0; copy < 40; ++copy) {
        for (glm::vec3 p : corners) {
            mesh.positions.push_back(p);
            mesh.normals.emplace_back(0.0f, 0.0f, 1.0f);
        }
        mesh.triangles.emplace_back(3 * copy, 3 * copy + 1, 3 * copy + 2);
    }
    const Mesh* const parts[] = {&mesh, &mesh};
    const Bvh bvh = buildBvh(parts);
    const BvhHit hit = nearest(bvh, glm::vec3(0.1f, 0.1f, 3.0f), glm::vec3(0, 0, -1));
    ASSERT_GE(hit.triangle, 0);
    EXPECT_EQ(hit.t, 3.0f);
    EXPECT_EQ(bvh.sources[hit.triangle].part, 0u);
    EXPECT_EQ(bvh.sources[hit.triangle].triangle, 0u);
    const BvhHit other =
        nearest(bvh, glm::vec3(0.1f, 0.1f, 3.0f), glm::vec3(0, 0, -1), hit.triangle);
    EXPECT_EQ(bvh.sources[other.triangle].triangle, 1u);
}

TEST(Bvh, HoldsEveryTriangleOnceWithItsNormalsAndPart) {
    const auto parts = makeShape("tumbler");
    const Bvh bvh = buildBvh(meshesOf(*parts));
    std::set<std::pair<unsigned, unsigned>> seen;
    for (int i = 0; i < bvh.triangleCount(); ++i) {
        const BvhSource source = bvh.sources[i];
        const Mesh& mesh = (*parts)[source.part].mesh;
        const glm::uvec3 t = mesh.triangles[source.triangle];
        const geometry::BvhSurface surface = geometry::bvhSurface(bvh.view(), i);
        ASSERT_EQ(surface.v0, mesh.positions[t.x]);
        ASSERT_EQ(surface.e2, mesh.positions[t.z] - mesh.positions[t.x]);
        ASSERT_EQ(surface.n1, mesh.normals[t.y]);
        ASSERT_EQ(surface.part, static_cast<int>(source.part));
        const std::size_t before = source.part == 0 ? 0 : (*parts)[0].mesh.triangles.size();
        ASSERT_EQ(surface.rank, static_cast<int>(before + source.triangle));
        seen.insert({source.part, source.triangle});
    }
    EXPECT_EQ(seen.size(), (*parts)[0].mesh.triangles.size() + (*parts)[1].mesh.triangles.size());
    EXPECT_EQ(bvh.nodes.size() % kBvhTextureWidth, 0u);
    EXPECT_EQ(bvh.triangles.size() % kBvhTextureWidth, 0u);
    EXPECT_EQ(bvh.normals.size() % kBvhTextureWidth, 0u);
}

TEST(Bvh, OfNothingIsNeverHit) {
    const Bvh bvh = buildBvh({});
    EXPECT_EQ(bvh.triangleCount(), 0);
    EXPECT_EQ(nearest(bvh, glm::vec3(0.0f), glm::vec3(0, 0, 1)).triangle, -1);
    EXPECT_EQ(nearest(bvh, glm::vec3(3.0f), glm::vec3(0, 1, 0)).triangle, -1);
}

TEST(Bvh, OfOneTriangle) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.normals.assign(3, glm::vec3(0, 0, 1));
    mesh.triangles = {{0, 1, 2}};
    const Bvh bvh = bvhOf(mesh);
    const BvhHit hit = nearest(bvh, glm::vec3(0.25f, 0.5f, 2.0f), glm::vec3(0, 0, -1));
    EXPECT_EQ(hit.triangle, 0);
    EXPECT_FLOAT_EQ(hit.t, 2.0f);
    EXPECT_FLOAT_EQ(hit.u, 0.25f);
    EXPECT_FLOAT_EQ(hit.v, 0.5f);
    EXPECT_EQ(nearest(bvh, glm::vec3(0.25f, 0.5f, 2.0f), glm::vec3(0, 0, 1)).triangle, -1);
    EXPECT_EQ(nearest(bvh, glm::vec3(0.6f, 0.5f, 2.0f), glm::vec3(0, 0, -1)).triangle, -1);
}

// From inside of a closed surface every ray meets it, also those aimed at edges and corners.
TEST(Bvh, HasNoGapsBetweenTriangles) {
    for (std::string_view name : {"sphere", "torus-knot", "brilliant", "tumbler"}) {
        const Mesh mesh = makeShape(name)->front().mesh;
        const Bvh bvh = bvhOf(mesh);
        const int rays = 60000;
        std::atomic<int> leaks = 0;
        parallelFor(0, rays, 4096, [&](int begin, int end) {
            Rays random(static_cast<unsigned>(begin));
            for (int i = begin; i < end; ++i) {
                // Just inside of a triangle, aimed at a corner or the middle of an edge.
                const glm::uvec3 t = mesh.triangles[i * 7919ll % mesh.triangles.size()];
                const glm::vec3 a = mesh.positions[t.x], b = mesh.positions[t.y],
                                c = mesh.positions[t.z];
                const glm::vec3 ng = glm::normalize(glm::cross(b - a, c - a));
                const float size = glm::length(b - a);
                const glm::vec3 origin =
                    (a + b + c) / 3.0f - random.between(0.01f, 0.1f) * size * ng;
                const glm::uvec3 s =
                    i % 2 == 0 ? t : mesh.triangles[i * 104729ll % mesh.triangles.size()];
                const glm::vec3 p = mesh.positions[s.x], q = mesh.positions[s.y];
                const glm::vec3 aim = i % 3 == 0 ? p : i % 3 == 1 ? 0.5f * (p + q) : q;
                if (nearest(bvh, origin, aim - origin).triangle < 0) ++leaks;
            }
        });
        EXPECT_EQ(leaks, 0) << name;
    }
}

// A ray that starts on a triangle of a sphere and goes inwards leaves through another one.
TEST(Bvh, RaysThatStartOnTheSurfaceSkipTheirTriangle) {
    const Mesh mesh = makeSphere(30);
    const Bvh bvh = bvhOf(mesh);
    Rays random(5);
    for (int i = 0; i < 50000; ++i) {
        const geometry::BvhSurface s = geometry::bvhSurface(bvh.view(), i % bvh.triangleCount());
        float u = random.between(0.0f, 1.0f), v = random.between(0.0f, 1.0f);
        if (u + v > 1.0f) u = 1.0f - u, v = 1.0f - v;
        const glm::vec3 ng = glm::normalize(glm::cross(s.e1, s.e2));
        glm::vec3 direction = random.direction();
        if (glm::dot(direction, ng) > 0.0f) direction = -direction;
        const glm::vec3 origin = s.v0 + u * s.e1 + v * s.e2;
        const BvhHit hit = nearest(bvh, origin, direction, i % bvh.triangleCount());
        ASSERT_GE(hit.triangle, 0) << i;
        ASSERT_NE(hit.triangle, i % bvh.triangleCount());
    }
}

TEST(Bvh, IsTheSameOnAnyNumberOfThreads) {
    const Mesh mesh = makeSphere(40);
    const Bvh all = bvhOf(mesh);
    setThreadCount(1);
    const Bvh one = bvhOf(mesh);
    setThreadCount(0);
    EXPECT_EQ(all.nodes, one.nodes);
    EXPECT_EQ(all.triangles, one.triangles);
}

// Each triangle half the size of the last and close to it: the heuristic cuts off one at a time.
TEST(Bvh, KeepsItsStackWithinItsPromise) {
    Mesh mesh;
    for (unsigned i = 0; i < 3000; ++i) {
        const float x = std::exp2(-static_cast<float>(i % 120)) * (1.0f + 0.001f * float(i / 120));
        const float size = 0.1f * x;
        mesh.positions.insert(
            mesh.positions.end(),
            {glm::vec3(x, 0, 0), glm::vec3(x + size, size, 0), glm::vec3(x, size, size)});
        mesh.normals.resize(mesh.positions.size(), glm::vec3(0, 0, 1));
        mesh.triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
    }
    const Bvh bvh = bvhOf(mesh);
    EXPECT_LE(bvh.stackSize, geometry::kBvhStackSize);
    for (int i = 0; i < 3000; ++i) {
        const glm::vec3 aim =
            (mesh.positions[3 * i] + mesh.positions[3 * i + 1] + mesh.positions[3 * i + 2]) / 3.0f;
        const glm::vec3 origin(-0.5f, 0.0f, aim.z);
        expectSame(nearest(bvh, origin, aim - origin), nearestOfAll(bvh, origin, aim - origin));
    }
}

TEST(Bvh, DepthLimitedTreesKeepTheirLimit) {
    std::vector<detail::BvhItem> items;
    for (unsigned i = 0; i < 4096; ++i) {
        const glm::vec3 p(std::exp2(-static_cast<float>(i % 100)), float(i % 7), float(i % 3));
        items.push_back({p, i, p});
    }
    const auto tree = detail::buildBinaryTree(items, 10);
    std::vector<std::pair<std::uint32_t, int>> pending{{0, 0}};
    std::size_t leaves = 0;
    while (!pending.empty()) {
        const auto [index, depth] = pending.back();
        pending.pop_back();
        if (tree[index].leaf()) {
            ++leaves;
            EXPECT_LE(depth, 10);
            EXPECT_LE(tree[index].count, detail::kMaxLeafSize);
            continue;
        }
        pending.push_back({tree[index].child, depth + 1});
        pending.push_back({tree[index].child + 1, depth + 1});
    }
    EXPECT_EQ(leaves, 1024u);
}

TEST(Bvh, RefusesPositionsThatAreNotNumbers) {
    Mesh mesh = makeSphere(2);
    mesh.positions[3].y = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THAT([&] { (void)bvhOf(mesh); }, testing::ThrowsMessage<Error>(testing::HasSubstr(
                                                "of part 0: a position is not a finite number")));
    mesh.positions[3].y = std::numeric_limits<float>::infinity();
    EXPECT_THROW((void)bvhOf(mesh), Error);
}

TEST(Bvh, RefusesMoreTrianglesThanItCanCount) {
    Mesh mesh = makeSphere(1);
    mesh.triangles.resize((1u << 20) + 1, glm::uvec3(0, 1, 2));
    const std::vector<const Mesh*> parts(16, &mesh);
    EXPECT_THAT([&] { (void)buildBvh(parts); },
                testing::ThrowsMessage<Error>("16777232 triangles; at most 16777216 can be traced "
                                              "at once: simplify the model"));
}

}  // namespace
}  // namespace tukor
