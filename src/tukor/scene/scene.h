// What is to be rendered: closed surfaces with materials, in world space.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "tukor/geometry/mesh.h"
#include "tukor/materials/material.h"
#include "tukor/scene/camera.h"
#include "tukor/scene/light.h"

namespace tukor {

/// One surface of one material. `mesh` is in world space: loaders apply node transforms.
struct Part {
    std::string name;          // mesh or node name, for `--material 'PATTERN=NAME'`
    std::string materialName;  // as the file calls it, likewise
    Material material;
    Mesh mesh;
};

struct NamedCamera {
    std::string name;
    Camera camera;
};

struct Scene {
    std::vector<Part> parts;
    std::vector<NamedCamera> cameras;   // those of the model file, if any
    std::vector<Light> lights;          // beside the environment
    std::vector<std::string> warnings;  // what is not rendered as the file asks, said once each
};

[[nodiscard]] Bounds boundsOf(const Scene& scene) noexcept;

/// A camera that shows the whole scene from a little above its front; `aspect` is width over
/// height.
[[nodiscard]] Camera framingCamera(const Scene& scene, float aspect) noexcept;

}  // namespace tukor
