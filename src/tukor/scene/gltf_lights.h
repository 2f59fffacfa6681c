// Lamps of glTF: KHR_lights_punctual.
#pragma once
#include "tukor/scene/gltf_nodes.h"
#include "tukor/scene/light.h"

namespace tukor {

/// The light of a node, in the world. Throws Error.
[[nodiscard]] Light readGltfLight(const GltfDocument& document, const GltfPlaced& placed);

}  // namespace tukor
