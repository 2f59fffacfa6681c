// The node tree of a glTF file, flattened: what is drawn where.
#pragma once
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "tukor/scene/gltf_animation.h"
#include "tukor/scene/gltf_document.h"

namespace tukor {

/// One mesh, camera or light of a node, and its place in the world.
struct GltfPlaced {
    std::size_t index;  // in `meshes`, `cameras` or `lights`
    std::string name;   // of the node, else of the mesh or camera
    glm::dmat4 worldFromNode;
    std::size_t node;  // its own index, for messages
    std::optional<std::size_t> skin = std::nullopt;
    std::vector<double> weights = {};  // of morph targets, where the node or its pose has them
};

struct GltfPlacements {
    std::deque<GltfPlaced> meshes;
    std::deque<GltfPlaced> cameras;
    std::deque<GltfPlaced> lights;          // of KHR_lights_punctual
    std::vector<glm::dmat4> worldFromNode;  // of every node; only of files with skins
};

/// Walks the default scene; the first one where there is no default, and all root nodes where there
/// are no scenes. Nodes are moved by `pose`. Throws Error where nodes do not form trees, as when
/// one is its own ancestor, or place more than 2^18 things.
[[nodiscard]] GltfPlacements placementsOf(const GltfDocument& document, const GltfPose& pose);

}  // namespace tukor
