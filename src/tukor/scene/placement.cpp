#include "tukor/scene/placement.h"

namespace tukor {

void place(Scene& scene, UpAxis up, float scale) {
    const auto turned = [&](glm::vec3 v) {
        return up == UpAxis::z ? glm::vec3(v.x, v.z, -v.y) : v;
    };
    const auto placed = [&](glm::vec3 p) { return scale * turned(p); };
    for (Part& part : scene.parts) {
        for (glm::vec3& p : part.mesh.positions) p = placed(p);
        for (glm::vec3& n : part.mesh.normals) n = turned(n);
        for (glm::vec4& t : part.mesh.tangents) t = glm::vec4(turned(glm::vec3(t)), t.w);
    }
    for (NamedCamera& named : scene.cameras) {
        named.camera.eye = placed(named.camera.eye);
        named.camera.target = placed(named.camera.target);
        named.camera.up = turned(named.camera.up);
    }
    for (Light& light : scene.lights) {
        light.position = placed(light.position);
        light.direction = turned(light.direction);
        light.range *= scale;
        if (light.kind != LightKind::directional) light.intensity *= scale * scale;
    }
}

}  // namespace tukor
