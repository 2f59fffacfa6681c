#include "tukor/geometry/revolution.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tukor/base/error.h"

namespace tukor {

namespace {

using glm::dvec2;

// Quarter turn clockwise: the right-hand side of a direction in (r, y).
dvec2 rightOf(dvec2 direction) {
    return dvec2(direction.y, -direction.x);
}

bool same(const ProfilePoint& a, const ProfilePoint& b) {
    return a.position == b.position && glm::dot(a.normal, b.normal) > 1.0 - 1e-9;
}

void addLine(Profile& profile, dvec2 from, dvec2 to, int steps) {
    if (glm::distance(from, to) < 1e-9) return;  // its two fillets touch
    const dvec2 normal = rightOf(glm::normalize(to - from));
    for (int i = 0; i <= steps; ++i) {
        const ProfilePoint point{i == steps ? to : glm::mix(from, to, double(i) / steps), normal};
        if (profile.empty() || !same(profile.back(), point)) profile.push_back(point);
    }
}

}  // namespace

Profile profileFromOutline(std::span<const OutlineCorner> outline, int arcSteps, int lineSteps) {
    Profile profile;
    dvec2 start = outline.front().position;
    for (std::size_t i = 1; i + 1 < outline.size(); ++i) {
        const dvec2 corner = outline[i].position;
        const dvec2 in = glm::normalize(corner - outline[i - 1].position);
        const dvec2 out = glm::normalize(outline[i + 1].position - corner);
        const double turn = std::atan2(in.x * out.y - in.y * out.x, glm::dot(in, out));
        const double radius = outline[i].filletRadius;
        if (radius == 0.0 || std::abs(turn) < 1e-9) {
            addLine(profile, start, corner, lineSteps);
            start = corner;
            continue;
        }
        // A left turn goes round a centre on the inside of the solid, a right turn outside.
        const double side = turn > 0.0 ? -1.0 : 1.0;
        const double reach = radius * std::tan(std::abs(turn) / 2.0);
        const dvec2 first = corner - reach * in, last = corner + reach * out;
        const dvec2 centre = first + side * radius * rightOf(in);
        addLine(profile, start, first, lineSteps);
        const int steps = std::max(
            2, static_cast<int>(std::ceil(arcSteps * std::abs(turn) / (0.5 * std::numbers::pi))));
        for (int k = 0; k <= steps; ++k) {
            const double angle = turn * k / steps;
            const dvec2 direction = std::cos(angle) * in - std::sin(angle) * rightOf(in);
            ProfilePoint point{centre - side * radius * rightOf(direction), rightOf(direction)};
            if (k == 0) point.position = first;
            if (k == steps) point = {last, rightOf(out)};
            if (profile.empty() || !same(profile.back(), point)) profile.push_back(point);
        }
        start = last;
    }
    addLine(profile, start, outline.back().position, lineSteps);
    return profile;
}

void append(Profile& profile, std::span<const ProfilePoint> next) {
    for (const ProfilePoint& point : next)
        if (profile.empty() || !same(profile.back(), point)) profile.push_back(point);
}

Mesh revolve(std::span<const ProfilePoint> profile, int sides) {
    TUKOR_ASSERT(sides >= 3 && profile.size() >= 2);
    Mesh mesh;
    const auto isPole = [](const ProfilePoint& point) { return point.position.x <= 0.0; };
    std::vector<unsigned> first;  // vertex of every profile point
    for (const ProfilePoint& point : profile) {
        first.push_back(static_cast<unsigned>(mesh.positions.size()));
        const int count = isPole(point) ? 1 : sides;
        for (int side = 0; side < count; ++side) {
            const double angle = 2.0 * std::numbers::pi * side / sides;
            const double c = isPole(point) ? 0.0 : std::cos(angle);
            const double s = isPole(point) ? 0.0 : std::sin(angle);
            mesh.positions.emplace_back(point.position.x * c, point.position.y,
                                        -point.position.x * s);
            mesh.normals.push_back(glm::vec3(glm::normalize(
                glm::dvec3(point.normal.x * c, point.normal.y, -point.normal.x * s))));
        }
    }
    for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
        if (profile[i].position == profile[i + 1].position) continue;  // a crease
        const bool fromPole = isPole(profile[i]), toPole = isPole(profile[i + 1]);
        for (int side = 0; side < sides; ++side) {
            const auto next = static_cast<unsigned>((side + 1) % sides);
            const auto here = static_cast<unsigned>(side);
            const unsigned a = first[i] + (fromPole ? 0 : here), b = first[i] + next;
            const unsigned c = first[i + 1] + (toPole ? 0 : here), d = first[i + 1] + next;
            if (!fromPole) mesh.triangles.emplace_back(a, b, c);
            if (!toPole) mesh.triangles.emplace_back(fromPole ? a : b, d, c);
        }
    }
    return mesh;
}

}  // namespace tukor
