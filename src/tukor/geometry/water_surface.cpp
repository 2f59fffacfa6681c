#include "tukor/geometry/water_surface.h"

#include <array>
#include <cmath>

#include "tukor/base/error.h"

namespace tukor {

namespace {

using glm::dvec2, glm::dvec3;

struct Wave {
    dvec2 wavenumber;  // radians per metre along x and z
    double amplitude;
    double phase;
};

// A breeze from one side: longer waves higher, directions spread by some 40 degrees. Slopes stay
// below 0.3, so that nothing overhangs and normals never turn away from the eye of the default
// view.
constexpr std::array kWaves = {
    Wave{{4.1, 1.3}, 0.016, 0.3},    Wave{{6.3, -2.9}, 0.009, 1.9},
    Wave{{5.2, 7.7}, 0.006, 4.1},    Wave{{13.0, 3.1}, 0.0035, 2.2},
    Wave{{11.0, -9.6}, 0.0025, 5.3}, Wave{{19.0, 12.0}, 0.0012, 0.9},
};

// Rings from a drop: crests 12 cm apart, fading outwards.
constexpr dvec2 kDrop(0.25, 0.2);
constexpr double kRingWavenumber = 52.0, kRingHeight = 0.006, kRingReach = 0.35;

struct Surface {
    double height;
    dvec2 slope;
};

Surface ripples(dvec2 p) {
    Surface surface{0.0, dvec2(0.0)};
    for (const Wave& wave : kWaves) {
        const double angle = glm::dot(wave.wavenumber, p) + wave.phase;
        surface.height += wave.amplitude * std::sin(angle);
        surface.slope += wave.amplitude * std::cos(angle) * wave.wavenumber;
    }
    // As a function of the squared distance it is smooth at the centre too.
    const dvec2 d = p - kDrop;
    const double distance = glm::length(d);
    const double fade = std::exp(-glm::dot(d, d) / (kRingReach * kRingReach));
    const double angle = kRingWavenumber * distance;
    surface.height += kRingHeight * fade * std::cos(angle);
    if (distance > 0.0)
        surface.slope += kRingHeight * fade *
                         (-kRingWavenumber * std::sin(angle) / distance -
                          2.0 * std::cos(angle) / (kRingReach * kRingReach)) *
                         d;
    return surface;
}

}  // namespace

Mesh makeWaterSurface(int steps) {
    TUKOR_ASSERT(steps >= 1);
    constexpr float bottom = -0.5f;
    Mesh mesh;
    const auto add = [&](glm::vec3 position, glm::vec3 normal) {
        mesh.positions.push_back(position);
        mesh.normals.push_back(normal);
        return static_cast<unsigned>(mesh.positions.size() - 1);
    };
    for (int row = 0; row <= steps; ++row)
        for (int column = 0; column <= steps; ++column) {
            const dvec2 p(2.0 * column / steps - 1.0, 2.0 * row / steps - 1.0);
            const Surface surface = ripples(p);
            add(glm::vec3(dvec3(p.x, surface.height, p.y)),
                glm::vec3(glm::normalize(dvec3(-surface.slope.x, 1.0, -surface.slope.y))));
        }
    const auto top = [&](int row, int column) {
        return static_cast<unsigned>(row * (steps + 1) + column);
    };
    for (int row = 0; row < steps; ++row)
        for (int column = 0; column < steps; ++column) {
            const unsigned a = top(row, column), b = top(row + 1, column);
            const unsigned c = top(row + 1, column + 1), d = top(row, column + 1);
            mesh.triangles.emplace_back(a, b, c);
            mesh.triangles.emplace_back(a, c, d);
        }

    // Four walls down from the top's border, and the floor as a fan over the same corners.
    const unsigned centre = add(glm::vec3(0.0f, bottom, 0.0f), glm::vec3(0.0f, -1.0f, 0.0f));
    const auto wall = [&](glm::vec3 normal, auto&& border) {
        for (int i = 0; i < steps; ++i) {
            const glm::vec3 p = mesh.positions[border(i)], q = mesh.positions[border(i + 1)];
            const glm::vec3 under(p.x, bottom, p.z), next(q.x, bottom, q.z);
            const unsigned a = add(p, normal), b = add(under, normal);
            const unsigned c = add(next, normal), d = add(q, normal);
            mesh.triangles.emplace_back(a, b, c);
            mesh.triangles.emplace_back(a, c, d);
            const glm::vec3 down(0.0f, -1.0f, 0.0f);
            const unsigned e = add(under, down), f = add(next, down);
            mesh.triangles.emplace_back(centre, f, e);
        }
    };
    wall(glm::vec3(0, 0, 1), [&](int i) { return top(steps, i); });
    wall(glm::vec3(1, 0, 0), [&](int i) { return top(steps - i, steps); });
    wall(glm::vec3(0, 0, -1), [&](int i) { return top(0, steps - i); });
    wall(glm::vec3(-1, 0, 0), [&](int i) { return top(i, 0); });
    return mesh;
}

Mesh makeBox(glm::vec3 least, glm::vec3 most) {
    Mesh mesh;
    for (int axis = 0; axis < 3; ++axis)
        for (int end = 0; end < 2; ++end) {
            const int right = (axis + 2 - end) % 3,
                      up = (axis + 1 + end) % 3;  // right x up points out
            glm::vec3 normal(0.0f), corner = least;
            normal[axis] = end == 0 ? -1.0f : 1.0f;
            corner[axis] = end == 0 ? least[axis] : most[axis];
            const auto first = static_cast<unsigned>(mesh.positions.size());
            for (int i = 0; i < 4; ++i) {
                glm::vec3 p = corner;
                p[right] = i == 1 || i == 2 ? most[right] : least[right];
                p[up] = i >= 2 ? most[up] : least[up];
                mesh.positions.push_back(p);
                mesh.normals.push_back(normal);
            }
            mesh.triangles.emplace_back(first, first + 1, first + 2);
            mesh.triangles.emplace_back(first, first + 2, first + 3);
        }
    return mesh;
}

}  // namespace tukor
