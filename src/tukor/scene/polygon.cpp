#include "tukor/scene/polygon.h"

#include <numeric>

namespace tukor {

namespace {

constexpr std::size_t kMostClipped = 64;  // ears are found in cubic time at worst

// Twice the area of a corner, positive where it is convex seen along the normal.
float turn(glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 normal) noexcept {
    return glm::dot(glm::cross(b - a, c - a), normal);
}

bool isInside(glm::vec3 p, glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 normal) noexcept {
    return turn(a, b, p, normal) >= 0.0f && turn(b, c, p, normal) >= 0.0f &&
           turn(c, a, p, normal) >= 0.0f;
}

// Twice the area vector. [Newell's method: Tampieri 1992]
glm::vec3 areaOf(std::span<const glm::vec3> corners) noexcept {
    glm::vec3 area(0.0f);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        area += glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
    return area;
}

bool isConvex(std::span<const glm::vec3> corners, glm::vec3 normal) noexcept {
    const std::size_t n = corners.size();
    for (std::size_t i = 0; i < n; ++i)
        if (turn(corners[i], corners[(i + 1) % n], corners[(i + 2) % n], normal) < 0.0f)
            return false;
    return true;
}

}  // namespace

void triangulate(std::span<const glm::vec3> corners, std::vector<glm::uvec3>& triangles) {
    const std::size_t n = corners.size();
    if (n < 3) return;
    const glm::vec3 normal = areaOf(corners);
    std::vector<unsigned> left(n);
    std::iota(left.begin(), left.end(), 0u);
    if (n > 3 && n <= kMostClipped && !isConvex(corners, normal)) {
        const auto isEar = [&](std::size_t i) {
            const std::size_t m = left.size();
            const unsigned a = left[(i + m - 1) % m], b = left[i], c = left[(i + 1) % m];
            if (!(turn(corners[a], corners[b], corners[c], normal) > 0.0f)) return false;
            for (const unsigned other : left)
                if (other != a && other != b && other != c &&
                    isInside(corners[other], corners[a], corners[b], corners[c], normal))
                    return false;
            return true;
        };
        std::size_t failures = 0;  // since the last ear
        for (std::size_t i = 0; left.size() > 3 && failures < left.size();) {
            i %= left.size();
            if (!isEar(i)) {
                ++i;
                ++failures;
                continue;
            }
            failures = 0;
            const std::size_t m = left.size();
            triangles.emplace_back(left[(i + m - 1) % m], left[i], left[(i + 1) % m]);
            left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
            i -= i > 0 ? 1 : 0;  // the corner before may have become an ear
        }
    }
    for (std::size_t i = 1; i + 1 < left.size(); ++i)
        triangles.emplace_back(left[0], left[i], left[i + 1]);
}

}  // namespace tukor
