// Small scenes and environments for tests of the CPU renderer.
#pragma once
#include <algorithm>
#include <cmath>
#include <string_view>

#include "tukor/environment/cube_texel.h"
#include "tukor/geometry/shapes.h"
#include "tukor/scene/scene.h"
#include "tukor/trace/error_estimate.h"

namespace tukor::trace {

[[nodiscard]] inline Material clear(float eta, int priority) {
    Material m;
    m.kind = MaterialKind::dielectric;
    m.eta = glm::vec3(eta);
    m.priority = priority;
    return m;
}

[[nodiscard]] inline Material metal() {
    Material m;
    m.kind = MaterialKind::metal;
    m.eta = {0.21f, 0.485f, 1.29f};
    m.k = {3.13f, 2.23f, 1.76f};
    return m;
}

[[nodiscard]] inline Scene sceneOfShape(std::string_view name, const Material& material) {
    Scene scene;
    std::vector<ShapePart> parts = *makeShape(name);
    for (ShapePart& part : parts) {
        scene.parts.push_back({part.name, part.material, material, std::move(part.mesh)});
    }
    return scene;
}

[[nodiscard]] inline Camera eyeAt(glm::vec3 eye) {
    Camera camera;
    camera.eye = eye;
    return camera;
}

[[nodiscard]] inline CubeMap constantCube(float value) {
    CubeMap cube(4);
    for (const CubeFace face : kCubeFaces) {
        for (glm::vec3& texel : cube.texels(face)) texel = glm::vec3(value);
    }
    return cube;
}

/// Smooth in most places, with a bright edge, so that pictures have something to get wrong.
[[nodiscard]] inline CubeMap gradientCube() {
    CubeMap cube(32);
    for (const CubeFace face : kCubeFaces) {
        for (int row = 0; row < 32; ++row) {
            for (int column = 0; column < 32; ++column) {
                const glm::vec3 d =
                    glm::normalize(directionFromTexel({face, column, row}, cube.faceSize()));
                const float band = std::sin(9.0f * d.x) * std::sin(7.0f * d.y + 1.0f) > 0.4f;
                cube.texels(face)[static_cast<std::size_t>(row * 32 + column)] =
                    glm::vec3(0.15f) + 0.1f * d + band * glm::vec3(0.8f, 0.7f, 0.5f);
            }
        }
    }
    return cube;
}

[[nodiscard]] inline Mesh boxMesh(glm::vec3 least, glm::vec3 most) {
    Mesh mesh;
    for (int axis = 0; axis < 3; ++axis) {
        for (const int side : {0, 1}) {
            glm::vec3 n(0.0f), a(0.0f), b(0.0f);
            n[axis] = side ? 1.0f : -1.0f;
            a[(axis + 1) % 3] = side ? 1.0f : -1.0f;
            b[(axis + 2) % 3] = 1.0f;
            const auto first = static_cast<unsigned>(mesh.positions.size());
            for (const glm::vec2 corner :
                 {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(1, 1), glm::vec2(-1, 1)}) {
                const glm::vec3 unit = n + corner.x * a + corner.y * b;
                mesh.positions.push_back(glm::mix(least, most, 0.5f * unit + 0.5f));
                mesh.normals.push_back(n);
            }
            mesh.triangles.push_back({first, first + 1, first + 2});
            mesh.triangles.push_back({first, first + 2, first + 3});
        }
    }
    return mesh;
}

/// 8-bit sRGB, clipped, over all channels.
[[nodiscard]] inline double rmse8(const Image& a, const Image& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.pixels().size(); ++i) {
        const glm::vec3 step = srgbCode(a.pixels()[i]) - srgbCode(b.pixels()[i]);
        sum += dot(step, step);
    }
    return std::sqrt(sum / (3.0 * static_cast<double>(a.pixels().size())));
}

}  // namespace tukor::trace
