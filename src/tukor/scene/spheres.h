// Which parts of a scene renderers meet as spheres in closed form.
#pragma once
#include <optional>
#include <vector>

#include "tukor/geometry/whole_sphere.h"
#include "tukor/scene/scene.h"

namespace tukor {

/// More would cost every ray more than a tree over their triangles.
inline constexpr int kMostSpheres = 8;

/// For each part, the sphere that it is. Parts that want their triangles, for textures, colours or
/// a rough finish, are none.
[[nodiscard]] std::vector<std::optional<Sphere>> spheresOf(const Scene& scene);

}  // namespace tukor
