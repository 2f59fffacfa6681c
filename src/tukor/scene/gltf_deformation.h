// Vertices of glTF moved by morph targets and by the joints of a skin.
#pragma once
#include <vector>

#include <glm/glm.hpp>

#include "tukor/geometry/mesh.h"
#include "tukor/scene/gltf_document.h"

namespace tukor {

/// What moves the vertices of one mesh.
struct GltfDeformation {
    std::vector<double> weights;            // of the morph targets
    std::vector<glm::dmat4> worldFromBind;  // of the joints; empty: no skin
};

/// The deformation of the joints of a skin, whose nodes are where `worldFromNode` says. Throws
/// Error.
[[nodiscard]] std::vector<glm::dmat4> jointsOf(const GltfDocument& document, const JsonItem& skin,
                                               const std::vector<glm::dmat4>& worldFromNode);

/// Moves `mesh`, which holds the vertices `used` of `primitive`. Afterwards skinned meshes are in
/// the world. Throws Error.
void deform(const GltfDocument& document, const JsonItem& primitive,
            const GltfDeformation& deformation, const std::vector<unsigned>& used, Mesh& mesh);

}  // namespace tukor
