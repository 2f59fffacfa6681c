// The node tree of a glTF file, flattened: what is drawn where.
#pragma once
#include <deque>
#include <string>

#include <glm/glm.hpp>

#include "tukor/scene/gltf_document.h"
#include "tukor/scene/notes.h"

namespace tukor {

/// One mesh or camera of a node, and its place in the world.
struct GltfPlaced {
    std::size_t index;  // in `meshes` or `cameras`
    std::string name;   // of the node, else of the mesh or camera
    glm::dmat4 worldFromNode;
    std::size_t node;  // its own index, for messages
};

struct GltfPlacements {
    std::deque<GltfPlaced> meshes;
    std::deque<GltfPlaced> cameras;
};

/// Walks the default scene; the first one where there is no default, and all root nodes where there
/// are no scenes. Throws Error where nodes do not form trees, as when one is its own ancestor, or
/// place more than 2^18 things.
[[nodiscard]] GltfPlacements placementsOf(const GltfDocument& document, Notes& notes);

}  // namespace tukor
