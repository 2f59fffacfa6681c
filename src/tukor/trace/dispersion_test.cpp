// Where a prism sends light of each wavelength.
#include "tukor/optics/dispersion.h"

#include <array>
#include <numbers>

#include <gtest/gtest.h>

#include "tukor/optics/fresnel.h"
#include "tukor/optics/spectrum.h"
#include "tukor/trace/render.h"
#include "tukor/trace/test_scenes.h"

namespace tukor::trace {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kEta = 1.7847f;  // of dense flint
constexpr float kDispersion = 20.0f / 25.76f;
constexpr float kApex = kPi / 3.0f;
constexpr float kIncidence = 1.1f;  // radians; about the least deviation

/// Heading of (-sin, 0, -cos).
glm::vec3 towards(float heading) {
    return {-std::sin(heading), 0.0f, -std::cos(heading)};
}

/// Its edge is along y; light along -z meets the middle of one face at kIncidence, and is turned
/// towards -x.
Mesh prism() {
    const glm::vec3 n1 = -towards(kIncidence), n2 = towards(kIncidence - kApex);
    glm::vec3 t1 = glm::cross(n1, glm::vec3(0, 1, 0)), t2 = glm::cross(n2, glm::vec3(0, 1, 0));
    if (glm::dot(t1, n2) > 0.0f) t1 = -t1;
    if (glm::dot(t2, n1) > 0.0f) t2 = -t2;
    const glm::vec3 edge = -0.5f * t1;
    const std::array<glm::vec3, 3> corners{edge, edge + t1, edge + t2};
    const glm::vec3 middle = (corners[0] + corners[1] + corners[2]) / 3.0f;
    Mesh mesh;
    const auto face = [&](std::initializer_list<glm::vec3> polygon) {
        const auto* p = polygon.begin();
        glm::vec3 n = glm::normalize(glm::cross(p[1] - p[0], p[2] - p[0]));
        const bool outward = glm::dot(n, p[0] - middle) > 0.0f;
        if (!outward) n = -n;
        const auto first = static_cast<unsigned>(mesh.positions.size());
        for (const glm::vec3& corner : polygon) {
            mesh.positions.push_back(corner);
            mesh.normals.push_back(n);
        }
        for (unsigned i = 2; i < polygon.size(); ++i)
            mesh.triangles.emplace_back(first, first + (outward ? i - 1 : i),
                                        first + (outward ? i : i - 1));
    };
    const glm::vec3 up(0, 1, 0);
    for (int i = 0; i < 3; ++i) {
        const glm::vec3 a = corners[static_cast<std::size_t>(i)],
                        b = corners[static_cast<std::size_t>((i + 1) % 3)];
        face({a - up, b - up, b + up, a + up});
    }
    face({corners[0] + up, corners[1] + up, corners[2] + up});
    face({corners[0] - up, corners[1] - up, corners[2] - up});
    return mesh;
}

/// By Snell's law at both faces.
float deviation(float eta) {
    const float inside = std::asin(std::sin(kIncidence) / eta);
    return kIncidence - kApex + std::asin(eta * std::sin(kApex - inside));
}

Scene scene() {
    Material flint = clear(kEta, 1);
    flint.dispersion = kDispersion;
    Scene scene;
    scene.parts.push_back({"prism", "", flint, prism()});
    return scene;
}

Camera narrow() {
    Camera camera = eyeAt({0, 0, 10});
    camera.target = glm::vec3(0.0f);
    camera.verticalFov = 1e-3f;
    return camera;
}

// The environment is white where a prism sends what is shorter than a wavelength, and black
// elsewhere: the picture's colour is what the spectrum up to there holds. 0.02: the panorama's
// texels are 1.5 nm wide.
TEST(Dispersion, PrismsTurnEachWavelengthBySnellsLaw) {
    const optics::Spectrum spectrum = optics::visibleSpectrum();
    for (const float edge : {470.0f, 550.0f, 610.0f}) {
        const float least = deviation(optics::indexAt(kEta, kDispersion, edge));
        Image panorama(8192, 64);
        for (int row = 0; row < panorama.height(); ++row)
            for (int column = 0; column < panorama.width(); ++column) {
                // -Z is the middle, +X to the right of it.
                const float heading =
                    -2.0f * kPi *
                    ((static_cast<float>(column) + 0.5f) / static_cast<float>(panorama.width()) -
                     0.5f);
                if (heading > least && heading < least + 0.5f)
                    panorama.at(column, row) = glm::vec3(1.0f);
            }
        RenderOptions options;
        options.width = options.height = 2;
        options.samples = 1024;
        options.fidelity = Fidelity::two;  // nothing reflects within
        const glm::vec3 seen = render(scene(), panorama, narrow(), options).radiance.at(1, 1);
        glm::vec3 expected(0.0f);
        constexpr int kCount = 4096;
        for (int i = 0; i < kCount; ++i) {
            const optics::Wavelength w =
                optics::wavelengthAt(spectrum, (static_cast<float>(i) + 0.5f) / kCount);
            const float eta = optics::indexAt(kEta, kDispersion, w.nm);
            if (w.nm < edge)
                expected += w.weight *
                            (1.0f - optics::fresnelDielectric(std::cos(kIncidence), eta)) /
                            static_cast<float>(kCount);
        }
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(seen[c], expected[c], 0.02f) << edge << ' ' << c;
    }
}

// The stone fills the picture: where only a part of a pixel's samples meet it they do not cover the
// spectrum evenly.
TEST(Dispersion, IsInvisibleInUniformLight) {
    Scene stone = sceneOfShape("brilliant", clear(2.4173f, 1));
    stone.parts[0].material.dispersion = 20.0f / 55.3f;
    RenderOptions options;
    options.width = options.height = 8;
    options.samples = 256;
    Camera camera = eyeAt({0, 1.5f, 3.0f});
    camera.target = glm::vec3(0.0f);
    camera.verticalFov = 0.15f;
    const Image image = render(stone, constantCube(1.0f), camera, options).radiance;
    for (const glm::vec3& pixel : image.pixels())
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(pixel[c], 1.0f, 0.02f);
}

}  // namespace
}  // namespace tukor::trace
