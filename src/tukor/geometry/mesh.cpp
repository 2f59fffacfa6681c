#include "tukor/geometry/mesh.h"

namespace tukor {

Bounds boundsOf(const Mesh& mesh) noexcept {
    Bounds bounds;
    for (glm::vec3 position : mesh.positions) bounds.include(position);
    return bounds;
}

}  // namespace tukor
