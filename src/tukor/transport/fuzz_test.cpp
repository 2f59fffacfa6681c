// Random scenes: whatever the solids, indices and eyes, nothing is lost and nothing goes wrong.
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "tukor/transport/test_host.h"

namespace tukor::transport {
namespace {

class RandomWorlds {
public:
    float uniform(float a, float b) { return std::uniform_real_distribution<float>(a, b)(random_); }
    int integer(int a, int b) { return std::uniform_int_distribution<int>(a, b)(random_); }
    vec3 point(float r) { return vec3(uniform(-r, r), uniform(-r, r), uniform(-r, r)); }

    /// One to six solids, boxes, tetrahedra or spheres, that may overlap in any way.
    TestWorld world(bool lossless) {
        TestWorld w;
        int solids = integer(1, 6);
        for (int i = 0; i < solids; ++i) {
            TestSurface surface;
            surface.kind = integer(0, 3) == 0 ? integer(0, 1) : kDielectric;
            if (lossless && surface.kind == kMetal) surface.kind = kMirror;
            if (!lossless) surface.tint = vec3(uniform(0, 1));
            surface.eta = vec3(uniform(0, 3), uniform(0, 3), uniform(0, 3));
            surface.k = vec3(uniform(0, 5));
            surface.inside = 1u << i;
            Medium m;
            // from air bubbles in water to diamond; now and then no interface at all
            m.eta = integer(0, 9) == 0 ? 1.0f : uniform(0.5f, 3.0f);
            m.sigmaA = lossless ? vec3(0.0f) : vec3(uniform(0, 20), uniform(0, 1), 0.0f);
            w.media.push_back(m);
            addSolid(w, surface);
        }
        return w;
    }

    /// Towards where the solids are, as a rule; some start within one.
    Branch ray() {
        vec3 origin = point(2.0f);
        return testRay(origin, point(1.0f) - origin);
    }

private:
    void addSolid(TestWorld& w, const TestSurface& surface) {
        int shape = integer(0, 2);
        float size = std::exp(uniform(integer(0, 3) == 0 ? -6.0f : -1.0f, 1.0f));  // 2 mm to 3 m
        vec3 c = point(1.0f);
        if (shape == 0) {
            w.spheres.push_back({c, size, surface});
        } else if (shape == 1) {
            addBox(w, c - vec3(size, size * uniform(1e-3f, 1), size), c + vec3(size), surface);
        } else {
            vec3 p[4] = {c, c + 2.0f * size * point(1), c + 2.0f * size * point(1),
                         c + 2.0f * size * point(1)};
            if (dot(cross(p[1] - p[0], p[2] - p[0]), p[3] - p[0]) > 0) std::swap(p[1], p[2]);
            const int faces[4][3] = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
            for (const auto& f : faces) {
                w.triangles.push_back({p[f[0]], p[f[1]], p[f[2]], surface});
            }
        }
    }

    std::mt19937 random_{20261122u};
};

bool sane(const Deposit& d) {
    float length2 = dot(d.direction, d.direction);
    return d.throughput.x >= 0.0f && d.throughput.y >= 0.0f && d.throughput.z >= 0.0f &&
           heaviness(d.throughput) <= 1.0001f && std::abs(length2 - 1.0f) < 1e-4f &&
           d.solidAngle >= 0.0f && std::isfinite(d.solidAngle);
}

TransportSettings randomSettings(RandomWorlds& random) {
    TransportSettings s = exactSettings();
    s.fidelity = random.integer(0, 5) == 0 ? random.integer(0, 1) : kFidelityExact;
    s.fresnel = random.integer(0, 1);
    s.rayBudget = 1 << random.integer(0, 8);
    s.maxDepth = 1 << random.integer(0, 6);
    s.weightCutoff = random.integer(0, 1) ? 0.0f : std::exp(random.uniform(-9.0f, -1.0f));
    s.splitGain = random.integer(0, 1) ? 0.0f : random.uniform(0.0f, 1.0f);
    return s;
}

TEST(TransportFuzz, HundredThousandScenesStayFiniteAndPositive) {
    RandomWorlds random;
    double rays = 0.0;
    for (int i = 0; i < 100000; ++i) {
        TestWorld world = random.world(false);
        Branch ray = random.ray();
        ray.footprint = cameraFootprint(ray.direction, random.point(1e-2f), random.point(1e-2f));
        ray.media = static_cast<uint>(random.integer(0, 63)) &
                    ((1u << world.media.size()) - 1u);  // as a rule a wrong one
        bool good = true;
        Tree end = world.trace(ray, randomSettings(random), static_cast<uint>(i),
                               [&](const Deposit& d) { good = good && sane(d); });
        ASSERT_TRUE(good) << "scene " << i;
        ASSERT_LE(end.rays, 256) << "scene " << i;
        rays += end.rays;
    }
    EXPECT_GT(rays / 100000, 4.0) << "the scenes are too empty to find anything";
}

TEST(TransportFuzz, WhiteFurnaceIsOneForEveryBudget) {
    RandomWorlds random;
    for (int i = 0; i < 20000; ++i) {
        TestWorld world = random.world(true);
        Branch ray = random.ray();
        double sum = 0.0;
        (void)world.trace(ray, randomSettings(random), static_cast<uint>(i),
                          [&](const Deposit& d) { sum += d.throughput.y; });
        ASSERT_NEAR(sum, 1.0, 1e-5) << "scene " << i;
    }
}

}  // namespace
}  // namespace tukor::transport
