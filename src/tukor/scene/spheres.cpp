#include "tukor/scene/spheres.h"

namespace tukor {

std::vector<std::optional<Sphere>> spheresOf(const Scene& scene) {
    std::vector<std::optional<Sphere>> spheres;
    int count = 0;
    for (const Part& part : scene.parts) {
        std::optional<Sphere>& sphere = spheres.emplace_back();
        if (count == kMostSpheres || part.material.finish != nullptr || !part.mesh.uvs[0].empty() ||
            !part.mesh.colors.empty()) {
            continue;
        }
        sphere = wholeSphere(part.mesh);
        count += sphere.has_value() ? 1 : 0;
    }
    return spheres;
}

}  // namespace tukor
