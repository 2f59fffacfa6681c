#include "tukor/trace/ground.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "tukor/scene/finish.h"
#include "tukor/scene/render_options.h"

namespace tukor::trace {

Scene withGround(const Scene& scene, float height) {
    Scene all = scene;
    const Bounds bounds = boundsOf(scene);
    const glm::vec3 middle = bounds.empty() ? glm::vec3(0.0f) : bounds.centre();
    const float half = kGroundSize * std::max(bounds.empty() ? 1.0f : bounds.radius(), 1e-3f);
    Mesh mesh;
    for (const float z : {-half, half})
        for (const float x : {-half, half}) {
            mesh.positions.emplace_back(middle.x + x, height, middle.z + z);
            mesh.normals.emplace_back(0.0f, 1.0f, 0.0f);
        }
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}};
    Finish finish;
    finish.catcher = true;
    Part ground{"ground", "ground", {}, std::move(mesh)};
    ground.material.finish = std::make_shared<Finish>(finish);
    all.parts.push_back(std::move(ground));
    return all;
}

glm::vec3 irradianceFromAbove(const EnvironmentMap& environment) noexcept {
    constexpr int kWidth = 1024, kRows = 256;  // of the upper half
    constexpr float kPi = std::numbers::pi_v<float>;
    constexpr float kStep = 2.0f * kPi / kWidth;
    glm::dvec3 sum(0.0);
    for (int row = 0; row < kRows; ++row) {
        const float theta = (static_cast<float>(row) + 0.5f) * kStep;
        const float s = std::sin(theta), c = std::cos(theta);
        for (int column = 0; column < kWidth; ++column) {
            const float phi = (static_cast<float>(column) + 0.5f) * kStep;
            const float x = std::cos(phi), z = std::sin(phi);
            const glm::vec3 L = environment.radiance(glm::vec3(s * x, c, s * z),
                                                     kStep * glm::vec3(-s * z, 0.0f, s * x),
                                                     kStep * glm::vec3(c * x, -s, c * z), 4);
            sum += glm::dvec3(L) * static_cast<double>(s * c);
        }
    }
    return glm::vec3(sum * static_cast<double>(kStep * kStep));
}

}  // namespace tukor::trace
