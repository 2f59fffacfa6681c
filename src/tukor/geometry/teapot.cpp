#include "tukor/geometry/teapot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace tukor {

namespace {

using glm::dvec3;
using Patch = std::array<std::array<dvec3, 4>, 4>;  // [row][column]; rows run along the part

// Newell's coordinates have z up; the factor makes the pot two metres long.
dvec3 worldFromNewell(dvec3 p) {
    constexpr double scale = 1.0 / 3.2625, middle = 1.575;
    return scale * dvec3(p.x, p.z - middle, -p.y);
}

struct Bezier {
    std::array<double, 4> value, derivative;
};

Bezier bernstein(double t) {
    const double s = 1.0 - t;
    return {{s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t},
            {-3.0 * s * s, 3.0 * s * (s - 2.0 * t), 3.0 * t * (2.0 * s - t), 3.0 * t * t}};
}

// Collects patches; vertices on their borders are shared where place and normal agree.
class Skin {
public:
    // `rows` squares along, `columns` across. The cross product of across and along points out.
    void add(const Patch& patch, int rows, int columns) {
        std::vector<unsigned> grid;
        for (int i = 0; i <= rows; ++i)
            for (int j = 0; j <= columns; ++j) {
                const Bezier along = bernstein(static_cast<double>(i) / rows);
                const Bezier across = bernstein(static_cast<double>(j) / columns);
                dvec3 p(0.0), du(0.0), dv(0.0), duv(0.0);
                for (int r = 0; r < 4; ++r)
                    for (int c = 0; c < 4; ++c) {
                        p += along.value[r] * across.value[c] * patch[r][c];
                        du += along.value[r] * across.derivative[c] * patch[r][c];
                        dv += along.derivative[r] * across.value[c] * patch[r][c];
                        duv += along.derivative[r] * across.derivative[c] * patch[r][c];
                    }
                // At a pole a whole border is one point: there du vanishes, but not how it grows
                // away from the pole (towards smaller rows at the last one).
                if (glm::dot(du, du) < 1e-20) du = i == 0 ? duv : -duv;
                const bool border = i == 0 || j == 0 || i == rows || j == columns;
                grid.push_back(vertex(p, glm::normalize(glm::cross(du, dv)), border));
            }
        for (int i = 0; i < rows; ++i)
            for (int j = 0; j < columns; ++j) {
                const unsigned a = grid[i * (columns + 1) + j], b = grid[i * (columns + 1) + j + 1];
                const unsigned c = grid[(i + 1) * (columns + 1) + j + 1];
                const unsigned d = grid[(i + 1) * (columns + 1) + j];
                triangle(a, b, c);
                triangle(a, c, d);
            }
    }

    // A flat fan over the loop of borders at the parts' first rows, or at their last.
    enum class End { first, last };
    void close(const std::array<std::array<dvec3, 4>, 2>& loop, int columns, End end) {
        std::vector<dvec3> points;
        dvec3 centre(0.0), normal(0.0);
        for (const auto& curve : loop)
            for (int j = 0; j < columns; ++j) {
                const Bezier across = bernstein(static_cast<double>(j) / columns);
                dvec3 p(0.0);
                for (int c = 0; c < 4; ++c) p += across.value[c] * curve[c];
                points.push_back(p);
                centre += p / (2.0 * columns);
            }
        // The patches run along the loop at their first rows, and back at their last.
        if (end == End::first) std::reverse(points.begin(), points.end());
        for (std::size_t i = 0; i < points.size(); ++i)
            normal += glm::cross(points[i], points[(i + 1) % points.size()]);
        normal = glm::normalize(normal);
        const unsigned middle = vertex(centre, normal, false);
        for (std::size_t i = 0; i < points.size(); ++i)
            triangle(middle, vertex(points[i], normal, true),
                     vertex(points[(i + 1) % points.size()], normal, true));
    }

    [[nodiscard]] Mesh take() { return std::move(mesh_); }

private:
    unsigned vertex(dvec3 p, dvec3 normal, bool border) {
        glm::vec3 position(p);
        if (border) {
            // Two patches reach the same place by different roundings; places that differ are
            // never this close. Half of a cell's size from its border a point has two cells.
            constexpr double cell = 1e-5;
            const auto key = [](dvec3 q) {
                return std::tuple(std::llround(q.x / cell), std::llround(q.y / cell),
                                  std::llround(q.z / cell));
            };
            for (int k = 0; k < 8; ++k) {
                const dvec3 nudge =
                    0.1 * cell * dvec3(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1);
                if (const auto found = borders_.find(key(p + nudge)); found != borders_.end()) {
                    position = mesh_.positions[found->second.front()];
                    for (unsigned known : found->second)
                        if (glm::dot(dvec3(mesh_.normals[known]), normal) > 0.9999) return known;
                }
            }
            for (int k = 0; k < 8; ++k) {
                const dvec3 nudge =
                    0.1 * cell * dvec3(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1);
                auto& known = borders_[key(p + nudge)];
                const auto self = static_cast<unsigned>(mesh_.positions.size());
                if (known.empty() || known.back() != self) known.push_back(self);
            }
        }
        mesh_.positions.push_back(position);
        mesh_.normals.emplace_back(normal);
        return static_cast<unsigned>(mesh_.positions.size() - 1);
    }

    void triangle(unsigned a, unsigned b, unsigned c) {
        const glm::vec3 p = mesh_.positions[a], q = mesh_.positions[b], r = mesh_.positions[c];
        if (p != q && q != r && r != p) mesh_.triangles.emplace_back(a, b, c);
    }

    Mesh mesh_;
    std::map<std::tuple<long long, long long, long long>, std::vector<unsigned>> borders_;
};

// A control point of the profile of body and lid. `round` places the inner control points of the
// quarter circles: Newell's choice is 0.56, but for the knob.
struct Ring {
    double radius;
    double height;
    double round = 0.56;
};

// The profile from the knob to the middle of the bottom, every four with the next one's first.
constexpr Ring kBody[] = {
    {0.0, 3.15},
    {0.8, 3.15, 0.5625},
    {0.0, 2.85},  // knob
    {0.2, 2.7},
    {0.4, 2.55},
    {1.3, 2.55},  // lid
    {1.3, 2.4},
    {1.0 / 3.0 + 1.0, 2.4},
    {1.1 / 3.0 + 1.0, 2.4},  // the gap, closed flat
    {1.4, 2.4},
    {1.3375, 2.53125},
    {1.4375, 2.53125},  // rim
    {1.5, 2.4},
    {1.75, 1.875},
    {2.0, 1.35},  // upper body
    {2.0, 0.9},
    {2.0, 0.45},
    {1.5, 0.225},  // lower body
    {1.5, 0.15},
    {1.5, 0.075},
    {1.425, 0.0},  // bottom
    {0.0, 0.0},
};

// A cross section of handle or spout in the plane y = 0: from `inner` to `outer` and `halfWidth` to
// both sides of the plane; x and z.
struct Section {
    double innerX, innerZ, outerX, outerZ, halfWidth;
};

constexpr Section kHandle[] = {
    {-1.6, 2.025, -1.5, 2.25, 0.3},
    {-2.3, 2.025, -2.5, 2.25, 0.3},
    {-2.7, 2.025, -3.0, 2.25, 0.3},
    {-2.7, 1.8, -3.0, 1.8, 0.3},
    {-2.7, 1.575, -3.0, 1.35, 0.3},
    {-2.5, 1.125, -2.65, 0.9375, 0.3},
    {-2.0, 0.9, -1.9, 0.6, 0.3},
    // Prolonged along its tangents, so that it ends inside of the body, not beside it.
    {-1.95, 0.8775, -1.825, 0.56625, 0.3},
    {-1.9, 0.855, -1.75, 0.5325, 0.3},
    {-1.85, 0.8325, -1.675, 0.49875, 0.3},
};

constexpr Section kSpout[] = {
    {1.7, 1.425, 1.7, 0.6, 0.66},       {2.6, 1.425, 3.1, 0.825, 0.66},
    {2.3, 2.1, 2.4, 2.025, 0.25},       {2.7, 2.4, 3.3, 2.4, 0.25},
    {2.8, 2.475, 3.525, 2.49375, 0.25}, {2.9, 2.475, 3.45, 2.5125, 0.15},
    {2.8, 2.4, 3.2, 2.4, 0.15},
};

Mesh revolvedBody() {
    Skin skin;
    for (std::size_t first = 0; first + 3 < std::size(kBody); first += 3)
        for (int quarter = 0; quarter < 4; ++quarter) {
            Patch patch;
            for (std::size_t row = 0; row < 4; ++row) {
                const auto [radius, height, round] = kBody[first + row];
                const dvec3 quadrant[4] = {{radius, 0.0, height},
                                           {radius, -radius * round, height},
                                           {radius * round, -radius, height},
                                           {0.0, -radius, height}};
                for (int column = 0; column < 4; ++column) {
                    dvec3 p = quadrant[column];
                    for (int turn = 0; turn < quarter; ++turn) p = dvec3(p.y, -p.x, p.z);
                    patch[row][column] = worldFromNewell(p);
                }
            }
            skin.add(patch, first == 6 ? 3 : 20, 40);
        }
    return skin.take();
}

// The sense in which the loop of inner and outer side goes round, seen along the tube.
enum class Turn { left, right };

template <std::size_t Size>
Mesh tube(const Section (&sections)[Size], Turn turn) {
    constexpr int columns = 32, rows = 48;
    Skin skin;
    std::array<std::array<dvec3, 4>, 2> firstLoop, lastLoop;
    for (std::size_t first = 0; first + 3 < Size; first += 3)
        for (std::size_t half = 0; half < 2; ++half) {
            Patch patch;
            for (std::size_t row = 0; row < 4; ++row) {
                const Section& s = sections[first + row];
                const double width = half == 0 ? s.halfWidth : -s.halfWidth;
                const dvec3 curve[4] = {{s.innerX, 0.0, s.innerZ},
                                        {s.innerX, width, s.innerZ},
                                        {s.outerX, width, s.outerZ},
                                        {s.outerX, 0.0, s.outerZ}};
                // One half runs from inner to outer, the other back: one loop, whose sense makes
                // the patches face outwards.
                const bool forth = (half == 0) == (turn == Turn::left);
                for (std::size_t column = 0; column < 4; ++column)
                    patch[row][column] = worldFromNewell(curve[forth ? column : 3 - column]);
            }
            skin.add(patch, rows, columns);
            if (first == 0) firstLoop[half] = patch[0];
            lastLoop[half] = patch[3];
        }
    skin.close(firstLoop, columns, Skin::End::first);
    skin.close(lastLoop, columns, Skin::End::last);
    return skin.take();
}

}  // namespace

Teapot makeTeapot() {
    return {revolvedBody(), tube(kSpout, Turn::right), tube(kHandle, Turn::right)};
}

}  // namespace tukor
