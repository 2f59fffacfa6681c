#include "tukor/geometry/sphere.h"

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "tukor/base/error.h"
#include "tukor/base/parallel.h"

namespace tukor {

namespace {

using glm::dvec3;

struct Icosahedron {
    std::array<dvec3, 12> corners;
    std::array<std::array<int, 3>, 20> faces;
};

// Two poles and two rings of five, turned against each other by half a step.
Icosahedron icosahedron() {
    Icosahedron solid{};
    solid.corners[0] = dvec3(0.0, 1.0, 0.0);
    solid.corners[11] = dvec3(0.0, -1.0, 0.0);
    const double height = 1.0 / std::sqrt(5.0);
    const double radius = 2.0 / std::sqrt(5.0);
    for (int i = 0; i < 5; ++i) {
        const double upper = 2.0 * std::numbers::pi * i / 5.0;
        const double lower = upper + std::numbers::pi / 5.0;
        solid.corners[1 + i] = dvec3(radius * std::sin(upper), height, radius * std::cos(upper));
        solid.corners[6 + i] = dvec3(radius * std::sin(lower), -height, radius * std::cos(lower));
    }
    for (int i = 0; i < 5; ++i) {
        const int next = (i + 1) % 5;
        solid.faces[i] = {0, 1 + i, 1 + next};
        solid.faces[5 + i] = {1 + i, 6 + i, 1 + next};
        solid.faces[10 + i] = {1 + next, 6 + i, 6 + next};
        solid.faces[15 + i] = {11, 6 + next, 6 + i};
    }
    return solid;
}

// Along the great circle, so that the steps of an edge are equal angles.
dvec3 between(dvec3 a, dvec3 b, double t) {
    const double angle = std::acos(glm::clamp(glm::dot(a, b), -1.0, 1.0));
    if (angle < 1e-12) return a;
    return (std::sin((1.0 - t) * angle) * a + std::sin(t * angle) * b) / std::sin(angle);
}

// A point inside a face, i + j + k = frequency steps from its sides: the mean of the three ways to
// reach it by great circles, which treats the corners alike and keeps triangles even.
dvec3 inside(dvec3 a, dvec3 b, dvec3 c, int i, int j, int k) {
    const double n = i + j + k;
    const dvec3 fromA =
        between(between(a, b, (n - i) / n), between(a, c, (n - i) / n), k / (n - i));
    const dvec3 fromB =
        between(between(b, c, (n - j) / n), between(b, a, (n - j) / n), i / (n - j));
    const dvec3 fromC =
        between(between(c, a, (n - k) / n), between(c, b, (n - k) / n), j / (n - k));
    return glm::normalize(fromA + fromB + fromC);
}

double areaOf(const Mesh& mesh) {
    double area = 0.0;
    for (glm::uvec3 t : mesh.triangles) {
        const dvec3 a(mesh.normals[t.x]), b(mesh.normals[t.y]), c(mesh.normals[t.z]);
        area += 0.5 * glm::length(glm::cross(b - a, c - a));
    }
    return area;
}

}  // namespace

Mesh makeSphere(int frequency) {
    TUKOR_ASSERT(frequency >= 1);
    const Icosahedron solid = icosahedron();
    const int n = frequency;
    Mesh mesh;
    for (dvec3 corner : solid.corners) mesh.normals.emplace_back(corner);

    // The vertices between two corners belong to both faces there: made once, from the lower
    // corner to the higher.
    std::map<std::pair<int, int>, int> edges;
    for (const auto& face : solid.faces)
        for (int side = 0; side < 3; ++side) {
            const int a = face[side], b = face[(side + 1) % 3];
            const std::pair key(std::min(a, b), std::max(a, b));
            if (!edges.try_emplace(key, static_cast<int>(mesh.normals.size())).second) continue;
            for (int i = 1; i < n; ++i)
                mesh.normals.emplace_back(between(solid.corners[key.first],
                                                  solid.corners[key.second],
                                                  static_cast<double>(i) / n));
        }
    const int insides = static_cast<int>(mesh.normals.size());
    const int perFace = (n - 1) * (n - 2) / 2;
    mesh.normals.resize(static_cast<std::size_t>(insides + 20 * perFace));
    mesh.triangles.resize(static_cast<std::size_t>(20) * n * n);

    // Row r of a face has r + 1 vertices, from the side a-b to the side a-c.
    parallelFor(0, 20, 1, [&](int first, int last) {
        for (int f = first; f < last; ++f) {
            const int ia = solid.faces[f][0], ib = solid.faces[f][1], ic = solid.faces[f][2];
            const dvec3 a = solid.corners[ia], b = solid.corners[ib], c = solid.corners[ic];
            const auto onEdge = [&](int from, int to, int step) {
                const int start = edges.at({std::min(from, to), std::max(from, to)});
                return start + (from < to ? step : n - step) - 1;
            };
            const auto vertex = [&](int row, int column) {
                if (row == 0) return ia;
                if (row == n && column == 0) return ib;
                if (row == n && column == n) return ic;
                if (column == 0) return onEdge(ia, ib, row);
                if (column == row) return onEdge(ia, ic, row);
                if (row == n) return onEdge(ib, ic, column);
                return insides + f * perFace + (row - 1) * (row - 2) / 2 + column - 1;
            };
            std::size_t next = static_cast<std::size_t>(f) * n * n;
            for (int row = 1; row <= n; ++row) {
                for (int column = 0; column < row; ++column) {
                    mesh.triangles[next++] = glm::uvec3(
                        vertex(row - 1, column), vertex(row, column), vertex(row, column + 1));
                    if (column + 1 < row)
                        mesh.triangles[next++] =
                            glm::uvec3(vertex(row - 1, column), vertex(row, column + 1),
                                       vertex(row - 1, column + 1));
                }
                if (row == n) continue;
                for (int column = 1; column < row; ++column)
                    mesh.normals[vertex(row, column)] =
                        glm::vec3(inside(a, b, c, n - row, row - column, column));
            }
        }
    });

    const auto radius = static_cast<float>(std::sqrt(4.0 * std::numbers::pi / areaOf(mesh)));
    mesh.positions.reserve(mesh.normals.size());
    for (glm::vec3& normal : mesh.normals) {
        normal = glm::normalize(normal);
        mesh.positions.push_back(radius * normal);
    }
    return mesh;
}

}  // namespace tukor
