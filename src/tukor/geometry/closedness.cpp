#include "tukor/geometry/closedness.h"

#include <algorithm>
#include <numeric>
#include <span>
#include <vector>

#include <fmt/format.h>

namespace tukor {

namespace {

// For every vertex the first one at the same place.
std::vector<unsigned> weld(const std::vector<glm::vec3>& positions) {
    std::vector<unsigned> order(positions.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto before = [&](unsigned a, unsigned b) {
        const glm::vec3 p = positions[a], q = positions[b];
        if (p.x != q.x) return p.x < q.x;
        if (p.y != q.y) return p.y < q.y;
        if (p.z != q.z) return p.z < q.z;
        return a < b;
    };
    std::sort(order.begin(), order.end(), before);
    std::vector<unsigned> first(positions.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        first[order[i]] = i > 0 && positions[order[i]] == positions[order[i - 1]]
                              ? first[order[i - 1]]
                              : order[i];
    return first;
}

/// As a triangle runs along it.
struct Edge {
    unsigned from, to;
};

/// Where the edges out of a vertex lead, in rising order.
class EdgesByVertex {
public:
    EdgesByVertex(std::span<const Edge> edges, std::size_t vertices)
        : starts_(vertices + 1, 0), ends_(edges.size()) {
        for (const Edge& edge : edges) ++starts_[edge.from];
        std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
        for (const Edge& edge : edges) ends_[--starts_[edge.from]] = edge.to;
        for (std::size_t v = 0; v < vertices; ++v)
            std::sort(ends_.begin() + starts_[v], ends_.begin() + starts_[v + 1]);
    }

    std::span<const unsigned> operator[](unsigned vertex) const {
        return std::span(ends_).subspan(
            static_cast<std::size_t>(starts_[vertex]),
            static_cast<std::size_t>(starts_[vertex + 1] - starts_[vertex]));
    }

private:
    std::vector<std::ptrdiff_t> starts_;
    std::vector<unsigned> ends_;
};

}  // namespace

ClosednessReport checkClosed(const Mesh& mesh) {
    ClosednessReport report;
    const std::vector<unsigned> first = weld(mesh.positions);
    std::vector<Edge> edges;
    edges.reserve(3 * mesh.triangles.size());
    std::vector<bool> used(mesh.positions.size(), false);
    std::int64_t faces = 0, vertices = 0;

    for (glm::uvec3 t : mesh.triangles) {
        const glm::vec3 p[3] = {mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]};
        const glm::dvec3 a(p[0]), b(p[1]), c(p[2]);
        report.volume += glm::dot(a, glm::cross(b, c)) / 6.0;
        const glm::dvec3 across = glm::cross(b - a, c - a);
        const unsigned corner[3] = {first[t.x], first[t.y], first[t.z]};
        if (corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0]) {
            ++report.degenerate;
            continue;  // it has no width: its neighbours meet without it
        }
        if (!(glm::dot(across, across) > 0.0)) ++report.degenerate;
        ++faces;
        for (int i = 0; i < 3; ++i) {
            if (!mesh.normals.empty() && !(glm::dot(glm::dvec3(mesh.normals[t[i]]), across) > 0.0))
                ++report.againstNormals;
            if (!used[corner[i]]) ++vertices;
            used[corner[i]] = true;
            edges.push_back({corner[i], corner[(i + 1) % 3]});
        }
    }

    const EdgesByVertex outOf(edges, mesh.positions.size());
    std::int64_t undirected = 0;
    for (unsigned from = 0; from < mesh.positions.size(); ++from) {
        const std::span<const unsigned> ends = outOf[from];
        for (auto end = ends.begin(); end != ends.end();) {
            const unsigned to = *end;
            const auto next = std::find_if(end, ends.end(), [&](unsigned v) { return v != to; });
            const std::int64_t count = next - end;
            const std::span<const unsigned> there = outOf[to];
            const auto [low, high] = std::equal_range(there.begin(), there.end(), from);
            const std::int64_t back = high - low;
            report.openEdges += std::max(count - back, std::int64_t{0});
            if (count > 1) ++report.nonManifoldEdges;
            if (back == 0 || from < to) ++undirected;
            end = next;
        }
    }
    report.eulerCharacteristic = vertices - undirected + faces;
    return report;
}

std::string warningOf(const ClosednessReport& report) {
    if (report.openEdges > 0)
        return fmt::format(
            "not closed: {} open edges; glass and water need closed surfaces: fill the holes and "
            "merge doubled vertices, or give it a metal",
            report.openEdges);
    if (report.volume <= 0.0)
        return "inside out: its triangles run clockwise seen from outside; flip its normals";
    return "";
}

}  // namespace tukor
