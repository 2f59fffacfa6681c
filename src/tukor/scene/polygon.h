// Polygons cut into triangles.
#pragma once
#include <span>
#include <vector>

#include <glm/glm.hpp>

namespace tukor {

/// Appends the n - 2 triangles of a simple polygon, as positions in `corners`, which may be concave
/// and a little bent. Falls back on a fan where it crosses itself or has more than 64 corners.
void triangulate(std::span<const glm::vec3> corners, std::vector<glm::uvec3>& triangles);

}  // namespace tukor
