// Surfaces of revolution about the y axis, from profiles of straight lines and fillets.
#pragma once
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "tukor/geometry/mesh.h"

namespace tukor {

/// A point of a profile in the half plane (r, y), r >= 0. Travelling along the profile, the outside
/// of the solid is on the right.
struct ProfilePoint {
    glm::dvec2 position;
    glm::dvec2 normal;  // unit, outward
};

/// Neighbours at one place with different normals make a crease.
using Profile = std::vector<ProfilePoint>;

/// A corner of an outline, rounded by an arc of that radius; 0 leaves it sharp.
struct OutlineCorner {
    glm::dvec2 position;
    double filletRadius = 0.0;
};

/// Lines from corner to corner with rounded corners. `arcSteps` divide a quarter circle,
/// `lineSteps` every line.
[[nodiscard]] Profile profileFromOutline(std::span<const OutlineCorner> outline, int arcSteps,
                                         int lineSteps);

/// The profile followed by `next`, which starts where it ends.
void append(Profile& profile, std::span<const ProfilePoint> next);

/// Turns the profile once about the y axis in `sides` steps. Points with r = 0 become poles.
[[nodiscard]] Mesh revolve(std::span<const ProfilePoint> profile, int sides);

}  // namespace tukor
