#include "tukor/geometry/brilliant.h"

#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "tukor/base/error.h"

namespace tukor {

namespace {

using glm::dvec3;

// Azimuths are in eighths of a turn, so that one turn further is the same place to the last bit.
dvec3 at(double radius, double eighths, double height) {
    const double azimuth = std::fmod(eighths + 8.0, 8.0) * std::numbers::pi / 4.0;
    return dvec3(radius * std::cos(azimuth), height, -radius * std::sin(azimuth));
}

// A flat convex polygon, counter-clockwise from outside, as a fan with one normal.
void addFacet(Mesh& mesh, std::span<const dvec3> corners) {
    dvec3 normal(0.0);  // Newell's: exact for a plane, whichever corners are close together
    for (std::size_t i = 0; i < corners.size(); ++i)
        normal += glm::cross(corners[i], corners[(i + 1) % corners.size()]);
    const auto first = static_cast<unsigned>(mesh.positions.size());
    for (dvec3 corner : corners) {
        mesh.positions.emplace_back(corner);
        mesh.normals.emplace_back(glm::normalize(normal));
    }
    for (unsigned i = 2; i < corners.size(); ++i)
        mesh.triangles.emplace_back(first, first + i - 1, first + i);
}

}  // namespace

Mesh makeBrilliant(const BrilliantOptions& options) {
    TUKOR_ASSERT(options.girdleFacets >= 16 && options.girdleFacets % 16 == 0);
    const double crown = std::tan(options.crownAngle), pavilion = std::tan(options.pavilionAngle);
    const double girdle = options.girdleThickness;  // half of it each side, of radius 1
    const double table = options.tableDiameter;     // a radius now
    const double total = 2.0 * girdle + (1.0 - table) * crown + pavilion;
    const double lift = 0.5 * total - girdle - (1.0 - table) * crown;

    // Main planes pass through the girdle's circle at the middle of each eighth; where two of them
    // meet, half an eighth away, sits the far corner of star or lower halves.
    const double half = std::cos(std::numbers::pi / 8.0);
    const auto crownHeight = [&](double r, double cosine) {
        return lift + girdle + (1.0 - r * cosine) * crown;
    };
    const auto pavilionHeight = [&](double r, double cosine) {
        return lift - girdle - (1.0 - r * cosine) * pavilion;
    };
    const double starRadius = table * half + options.starLength * (1.0 - table * half);
    const double lowerRadius = 1.0 - options.lowerHalfLength;
    const auto tableCorner = [&](int k) { return at(table, k, crownHeight(table, 1.0)); };
    const auto starTip = [&](int k) {
        return at(starRadius, k + 0.5, crownHeight(starRadius, half));
    };
    const auto lowerTip = [&](int k) {
        return at(lowerRadius, k + 0.5, pavilionHeight(lowerRadius, half));
    };
    const dvec3 culet = at(0.0, 0.0, pavilionHeight(0.0, 1.0));

    // The girdle's edges are where the halves' planes cut its polygon: on each sixteenth, through
    // its two ends at full thickness and the tip.
    const int steps = options.girdleFacets / 16;
    const auto edge = [&](int sixteenth, dvec3 tip, double height) {
        std::vector<dvec3> points;
        const dvec3 a = at(1.0, sixteenth * 0.5, height);
        const dvec3 b = at(1.0, (sixteenth + 1) * 0.5, height);
        const dvec3 normal = glm::cross(b - a, tip - a);
        for (int i = 0; i <= steps; ++i) {
            const double azimuth = (sixteenth + static_cast<double>(i) / steps) * 0.5;
            dvec3 point = at(1.0, azimuth, height);
            if (i > 0 && i < steps)
                point.y =
                    a.y - (normal.x * (point.x - a.x) + normal.z * (point.z - a.z)) / normal.y;
            points.push_back(point);
        }
        return points;
    };

    Mesh mesh;
    std::vector<dvec3> corners(8);
    for (int k = 0; k < 8; ++k) corners[static_cast<std::size_t>(k)] = tableCorner(k);
    addFacet(mesh, corners);
    for (int k = 0; k < 8; ++k) {
        const dvec3 onGirdle = at(1.0, k, lift + girdle);
        const dvec3 underGirdle = at(1.0, k, lift - girdle);
        addFacet(mesh, std::vector{tableCorner(k + 1), tableCorner(k), starTip(k)});        // star
        addFacet(mesh, std::vector{tableCorner(k), starTip(k - 1), onGirdle, starTip(k)});  // bezel
        addFacet(mesh, std::vector{culet, lowerTip(k), underGirdle, lowerTip(k - 1)});      // main
    }
    for (int sixteenth = 0; sixteenth < 16; ++sixteenth) {
        const dvec3 star = starTip(sixteenth / 2), lower = lowerTip(sixteenth / 2);
        const std::vector<dvec3> above = edge(sixteenth, star, lift + girdle);
        const std::vector<dvec3> below = edge(sixteenth, lower, lift - girdle);
        corners.assign(1, star);
        corners.insert(corners.end(), above.begin(), above.end());
        addFacet(mesh, corners);  // upper half
        corners.assign(1, lower);
        corners.insert(corners.end(), below.rbegin(), below.rend());
        addFacet(mesh, corners);  // lower half
        for (int i = 0; i < steps; ++i)
            addFacet(mesh, std::vector{above[i], below[i], below[i + 1], above[i + 1]});
    }
    return mesh;
}

}  // namespace tukor
