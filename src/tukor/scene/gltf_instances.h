// Many of one mesh in glTF: EXT_mesh_gpu_instancing.
#pragma once
#include <vector>

#include <glm/glm.hpp>

#include "tukor/scene/gltf_document.h"

namespace tukor {

/// Where a node's mesh is drawn, in the node's space, as its `extension` says. Throws Error.
[[nodiscard]] std::vector<glm::dmat4> instancesOf(const GltfDocument& document,
                                                  const JsonItem& extension, std::size_t most);

}  // namespace tukor
