#include "tukor/scene/crease_normals.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "tukor/base/parallel.h"
#include "tukor/scene/interner.h"
#include "tukor/scene/mesh_details.h"

namespace tukor {

namespace {

constexpr int kGrain = 1 << 14;  // vertices or triangles per task: a millisecond or so

// The corners around each vertex: corner c is vertex c % 3 of triangle c / 3.
struct Fans {
    std::vector<unsigned> first;    // of vertex v: [first[v], first[v + 1])
    std::vector<unsigned> corners;  // grouped by vertex
};

Fans fansOf(std::size_t vertices, const std::vector<glm::uvec3>& triangles) {
    Fans fans;
    fans.first.assign(vertices + 1, 0);
    for (const glm::uvec3 t : triangles)
        for (int i = 0; i < 3; ++i) ++fans.first[t[i] + 1];
    for (std::size_t v = 0; v < vertices; ++v) fans.first[v + 1] += fans.first[v];
    fans.corners.resize(3 * triangles.size());
    std::vector<unsigned> next(fans.first.begin(), fans.first.end() - 1);
    for (std::size_t i = 0; i < triangles.size(); ++i)
        for (int c = 0; c < 3; ++c)
            fans.corners[next[triangles[i][c]]++] = static_cast<unsigned>(3 * i) + unsigned(c);
    return fans;
}

glm::vec3 unitOrZero(glm::dvec3 v) noexcept {
    const double length = glm::length(v);
    return length > 0.0 ? glm::vec3(v / length) : glm::vec3(0.0f);
}

// Parts the corners around one vertex into sides, numbered from 0. Scratch space is kept.
class Sides {
public:
    Sides(const std::vector<glm::uvec3>& triangles, const std::vector<glm::vec3>& facets,
          float cosCrease)
        : triangles_(triangles), facets_(facets), cosCrease_(cosCrease) {
        // Facets this near to one are near enough to each other.
        cosHalfCrease_ = std::sqrt(std::max(0.0f, 0.5f + 0.5f * cosCrease));
    }

    // sides[i] for corners[i]; returns how many there are.
    unsigned of(const unsigned* corners, std::size_t count, unsigned* sides) {
        if (allNear(corners, count)) {
            std::fill_n(sides, count, 0u);
            return count > 0 ? 1u : 0u;
        }
        edges_.clear();
        parent_.resize(count);
        for (unsigned i = 0; i < count; ++i) {
            const glm::uvec3 t = triangles_[corners[i] / 3];
            const int c = static_cast<int>(corners[i] % 3);
            edges_.emplace_back(t[(c + 1) % 3], i);
            edges_.emplace_back(t[(c + 2) % 3], i);
            parent_[i] = i;
        }
        std::sort(edges_.begin(), edges_.end());
        for (std::size_t e = 1; e < edges_.size(); ++e) {
            if (edges_[e].first != edges_[e - 1].first) continue;
            const unsigned a = edges_[e - 1].second, b = edges_[e].second;
            if (glm::dot(facet(corners[a]), facet(corners[b])) > cosCrease_)
                parent_[root(a)] = root(b);
        }
        unsigned found = 0;
        number_.assign(count, ~0u);
        for (unsigned i = 0; i < count; ++i) {
            unsigned& number = number_[root(i)];
            if (number == ~0u) number = found++;
            sides[i] = number;
        }
        return found;
    }

private:
    [[nodiscard]] glm::vec3 facet(unsigned corner) const { return facets_[corner / 3]; }

    [[nodiscard]] bool allNear(const unsigned* corners, std::size_t count) const {
        for (std::size_t i = 1; i < count; ++i)
            if (!(glm::dot(facet(corners[0]), facet(corners[i])) > cosHalfCrease_)) return false;
        return true;
    }

    unsigned root(unsigned i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }

    const std::vector<glm::uvec3>& triangles_;
    const std::vector<glm::vec3>& facets_;
    float cosCrease_;
    float cosHalfCrease_;
    std::vector<std::pair<unsigned, unsigned>> edges_;  // far vertex, position in the fan
    std::vector<unsigned> parent_;
    std::vector<unsigned> number_;
};

float angleAt(glm::vec3 p, glm::vec3 q, glm::vec3 r) noexcept {
    const glm::vec3 a = q - p, b = r - p;
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

}  // namespace

Mesh creaseNormalsOfWelded(std::vector<glm::vec3> positions, std::vector<glm::uvec3> triangles,
                           float creaseAngle) {
    const int vertices = static_cast<int>(positions.size());
    std::vector<glm::vec3> facets(triangles.size());
    parallelFor(0, static_cast<int>(triangles.size()), kGrain, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
            const glm::uvec3 t = triangles[std::size_t(i)];
            const glm::dvec3 a(positions[t.x]), b(positions[t.y]), c(positions[t.z]);
            facets[std::size_t(i)] = unitOrZero(glm::cross(b - a, c - a));
        }
    });

    const Fans fans = fansOf(positions.size(), triangles);
    std::vector<unsigned> sides(fans.corners.size());  // of fans.corners[i]
    std::vector<unsigned> firstSide(positions.size() + 1, 0);
    parallelFor(0, vertices, kGrain, [&](int begin, int end) {
        Sides fan(triangles, facets, std::cos(creaseAngle));
        for (auto v = std::size_t(begin); v < std::size_t(end); ++v) {
            const unsigned from = fans.first[v], to = fans.first[v + 1];
            firstSide[v + 1] = fan.of(fans.corners.data() + from, to - from, sides.data() + from);
        }
    });
    for (std::size_t v = 0; v < positions.size(); ++v) firstSide[v + 1] += firstSide[v];

    Mesh result;
    result.positions.resize(firstSide.back());
    result.normals.assign(firstSide.back(), glm::vec3(0.0f));
    result.triangles.resize(triangles.size());
    parallelFor(0, vertices, kGrain, [&](int begin, int end) {
        for (auto v = std::size_t(begin); v < std::size_t(end); ++v) {
            for (unsigned i = fans.first[v]; i < fans.first[v + 1]; ++i) {
                const unsigned corner = fans.corners[i];
                const glm::uvec3 t = triangles[corner / 3];
                const int c = static_cast<int>(corner % 3);
                const unsigned vertex = firstSide[v] + sides[i];
                result.triangles[corner / 3][c] = vertex;
                result.normals[vertex] +=
                    angleAt(positions[v], positions[t[(c + 1) % 3]], positions[t[(c + 2) % 3]]) *
                    facets[corner / 3];
            }
            for (unsigned vertex = firstSide[v]; vertex < firstSide[v + 1]; ++vertex) {
                result.positions[vertex] = positions[v];
                const glm::vec3 normal = unitOrZero(result.normals[vertex]);
                // Only triangles without area meet here: any direction will do.
                result.normals[vertex] = normal == glm::vec3(0.0f) ? glm::vec3(0, 1, 0) : normal;
            }
        }
    });
    return result;
}

Mesh withCreaseNormals(const Mesh& mesh, float creaseAngle) {
    Interner<glm::vec3> places(mesh.positions.size());
    std::vector<unsigned> welded(mesh.positions.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        welded[i] = places.add(mesh.positions[i]);
    std::vector<glm::uvec3> triangles, originals;
    triangles.reserve(mesh.triangles.size());
    const bool detailed = hasDetails(mesh);
    for (const glm::uvec3 t : mesh.triangles) {
        const glm::uvec3 merged(welded[t.x], welded[t.y], welded[t.z]);
        if (merged.x == merged.y || merged.y == merged.z || merged.z == merged.x) continue;
        triangles.push_back(merged);
        if (detailed) originals.push_back(t);
    }
    Mesh result =
        creaseNormalsOfWelded(std::move(places).take(), std::move(triangles), creaseAngle);
    return detailed ? withDetailsOf(mesh, originals, std::move(result)) : result;
}

}  // namespace tukor
