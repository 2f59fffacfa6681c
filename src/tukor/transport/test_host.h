// A host of the transport for tests: a list of triangles and spheres, searched one by one, in
// double where it matters.
#pragma once
#include <optional>
#include <vector>

#include "tukor/transport/path_tree.h"

namespace tukor::transport {

struct TestSurface {
    int kind = kDielectric;
    vec3 tint{1.0f};
    vec3 eta{1.5f};
    vec3 k{0.0f};
    uint inside = 0u;
    uint outside = 0u;
};

struct TestTriangle {
    vec3 v0, v1, v2;
    TestSurface surface;
};

/// Exact, with the normal of the sphere. `radius` < 0: the outside is within.
struct TestSphere {
    vec3 centre{0.0f};
    float radius = 1.0f;
    TestSurface surface;
};

struct TestWorld {
    std::vector<TestTriangle> triangles;
    std::vector<TestSphere> spheres;
    std::vector<Medium> media;

    [[nodiscard]] Medium mediumAt(int number) const {
        return number == kVacuum ? vacuum() : media[static_cast<std::size_t>(number)];
    }

    [[nodiscard]] std::optional<SurfaceHit> nearest(const Branch& ray) const {
        SurfaceHit best{};
        best.distance = 1e30f;
        bool found = false;
        for (std::size_t i = 0; i < triangles.size(); ++i) {
            if (static_cast<int>(i) == ray.skip) continue;
            const TestTriangle& t = triangles[i];
            vec3 e1 = t.v1 - t.v0, e2 = t.v2 - t.v0;
            vec3 p = cross(ray.direction, e2);
            float det = dot(e1, p);
            if (det == 0.0f) continue;
            vec3 s = ray.origin - t.v0;
            float u = dot(s, p) / det;
            vec3 q = cross(s, e1);
            float v = dot(ray.direction, q) / det;
            float distance = dot(e2, q) / det;
            if (!(u >= 0.0f && v >= 0.0f && u + v <= 1.0f && distance > 0.0f)) continue;
            if (distance >= best.distance) continue;
            found = true;
            fill(best, t.surface, static_cast<int>(i), distance, t.v0 + u * e1 + v * e2);
            best.e1 = e1;
            best.e2 = e2;
            best.normal = normalize(cross(e1, e2));
            best.normalE1 = best.normalE2 = vec3(0.0f);
        }
        for (std::size_t i = 0; i < spheres.size(); ++i) {
            const TestSphere& s = spheres[i];
            int name = static_cast<int>(triangles.size() + i);
            glm::dvec3 o = glm::dvec3(ray.origin - s.centre), d = glm::dvec3(ray.direction);
            double b = glm::dot(o, d), c = glm::dot(o, o) - double(s.radius) * s.radius;
            double disc = b * b - glm::dot(d, d) * c;
            if (disc <= 0.0) continue;
            // The way to the far side is the one that a ray from the sphere itself has left.
            double near = -b - std::sqrt(disc), far = -b + std::sqrt(disc);
            bool onIt = name == ray.skip;
            double distance = !onIt && near > 0.0 ? near : far;
            if (distance <= (onIt ? 1e-4 * std::abs(s.radius) : 0.0)) continue;
            if (distance >= best.distance) continue;
            found = true;
            vec3 n = vec3(glm::normalize(o + distance * d));
            fill(best, s.surface, name, static_cast<float>(distance),
                 s.centre + std::abs(s.radius) * n);
            vec3 a = std::abs(n.x) < 0.5f ? vec3(1, 0, 0) : vec3(0, 1, 0);
            float sign = s.radius < 0.0f ? -1.0f : 1.0f;
            best.normal = n * sign;
            best.e1 = normalize(cross(a, n));
            best.e2 = cross(n, best.e1) * sign;
            best.normalE1 = best.e1 / s.radius;
            best.normalE2 = best.e2 / s.radius;
        }
        return found ? std::optional(best) : std::nullopt;
    }

    /// Traces the whole tree from a ray; `look(Deposit)` is called for every look-up.
    template <class Look>
    Tree trace(const Branch& ray, const TransportSettings& settings, uint seed, Look&& look) const {
        Tree tree = startTree(ray, seed, 0u);
        while (tree.alive) {
            Deposits deposits;
            if (spent(tree, settings)) {
                deposits = cutBranch(tree);
            } else {
                tree.rays++;
                if (std::optional<SurfaceHit> hit = nearest(tree.branch)) {
                    Encounter met = encounter(tree.branch, *hit);
                    deposits =
                        scatter(tree, *hit, met, mediumAt(met.from), mediumAt(met.to), settings);
                } else {
                    deposits = escape(tree);
                }
            }
            if (deposits.count > 0) look(deposits.first);
            if (deposits.count > 1) look(deposits.second);
        }
        return tree;
    }

private:
    static void fill(SurfaceHit& hit, const TestSurface& surface, int name, float distance,
                     vec3 position) {
        hit.distance = distance;
        hit.position = position;
        hit.triangle = name;
        hit.kind = surface.kind;
        hit.tint = surface.tint;
        hit.eta = surface.eta;
        hit.k = surface.k;
        hit.inside = surface.inside;
        hit.outside = surface.outside;
    }
};

[[nodiscard]] inline Branch testRay(vec3 origin, vec3 direction) {
    Branch ray;
    ray.origin = origin;
    ray.direction = normalize(direction);
    ray.throughput = vec3(1.0f);
    ray.footprint = thinFootprint();
    ray.media = 0u;
    ray.skip = -1;
    ray.depth = 0;
    return ray;
}

[[nodiscard]] inline TransportSettings exactSettings() {
    TransportSettings s;
    s.fidelity = kFidelityExact;
    s.fresnel = kFresnelExact;
    s.rayBudget = 128;
    s.maxDepth = 64;
    s.weightCutoff = 1e-3f;
    s.splitGain = 0.0f;
    return s;
}

/// A box as twelve triangles, wound outwards.
inline void addBox(TestWorld& world, vec3 least, vec3 most, const TestSurface& surface) {
    auto corner = [&](int i) {
        return vec3(i & 1 ? most.x : least.x, i & 2 ? most.y : least.y, i & 4 ? most.z : least.z);
    };
    const int quads[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                             {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    for (const auto& q : quads) {
        world.triangles.push_back({corner(q[0]), corner(q[1]), corner(q[2]), surface});
        world.triangles.push_back({corner(q[0]), corner(q[2]), corner(q[3]), surface});
    }
}

}  // namespace tukor::transport
