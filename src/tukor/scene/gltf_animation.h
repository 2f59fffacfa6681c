// Animations of glTF at one moment: how they move nodes and weigh morph targets.
#pragma once
#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include "tukor/scene/gltf_document.h"

namespace tukor {

/// What an animation says of one node; absent members are the node's own.
struct GltfNodePose {
    std::optional<glm::dvec3> translation;
    std::optional<glm::dquat> rotation;
    std::optional<glm::dvec3> scale;
    std::vector<double> weights;
};

/// By the node's index.
using GltfPose = std::map<std::size_t, GltfNodePose>;

/// An animation after `seconds`; before its first and after its last moment it stands still.
/// `animation` is a name or a number, see ModelOptions. Throws Error.
[[nodiscard]] GltfPose poseAt(const GltfDocument& document, std::string_view animation,
                              double seconds);

/// How long an animation lasts, in seconds: when its last channel stands still; 0 where there is
/// none of that name. Throws Error.
[[nodiscard]] double secondsOf(const GltfDocument& document, std::string_view animation);

}  // namespace tukor
