#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tukor/geometry/shapes.h"
#include "tukor/gl/context.h"
#include "tukor/gl/eye_media.h"
#include "tukor/gl/render.h"
#include "tukor/gl/renderer.h"
#include "tukor/materials/materials.h"

namespace tukor::gl {
namespace {

Environment white(int faceSize = 4) {
    Environment environment{"white", CubeMap(faceSize), {}};
    for (const CubeFace face : kCubeFaces)
        for (glm::vec3& texel : environment.radiance.texels(face)) texel = glm::vec3(1.0f);
    return environment;
}

Scene sceneOf(std::string_view shape, std::string_view material) {
    Scene scene;
    std::vector<ShapePart> parts = makeShape(shape).value();
    for (ShapePart& part : parts)
        scene.parts.push_back({part.name, part.material,
                               parseMaterial(part.material.empty() ? material : part.material),
                               std::move(part.mesh)});
    return scene;
}

RenderOptions tiny(Fidelity fidelity) {
    RenderOptions options;
    options.width = 48;
    options.height = 27;
    options.samples = 1;
    options.fidelity = fidelity;
    return options;
}

double largestDistanceFromOne(const Image& image) {
    double largest = 0.0;
    for (const glm::vec3& pixel : image.pixels())
        for (int i = 0; i < 3; ++i)
            largest = std::max(largest, std::abs(static_cast<double>(pixel[i]) - 1.0));
    return largest;
}

// The white furnace on ground: what things hide of the light on it comes through them.
TEST(Traced, GroundUnderGlassInUniformLightIsInvisible) {
    const Scene scene = sceneOf("sphere", "glass");
    Camera camera = framingCamera(scene, 16.0f / 9.0f);
    camera.eye.y += 2.0f;
    RenderOptions options = tiny(Fidelity::exact);
    options.samples = 64;
    options.ground = -1.0f;
    const Image image = render(scene, white(32), camera, options).radiance;
    glm::dvec3 mean(0.0);
    for (const glm::vec3& pixel : image.pixels()) mean += glm::dvec3(pixel);
    EXPECT_NEAR(mean.y / static_cast<double>(image.pixels().size()), 1.0, 2e-3);
    EXPECT_LT(largestDistanceFromOne(image), 0.3);
    EXPECT_GT(largestDistanceFromOne(image), 0.01) << "no ground";
}

// Where no background is drawn shadows are what covers it, and light is added to it.
TEST(Traced, ShadowsCoverWhatIsNoBackground) {
    const Scene scene = sceneOf("sphere", "silver");
    Camera camera = framingCamera(scene, 16.0f / 9.0f);
    camera.eye.y += 2.0f;
    RenderOptions options = tiny(Fidelity::exact);
    options.background = Background::none;
    options.samples = 32;
    options.ground = -1.0f;
    const Image with = render(scene, white(), camera, options).radiance;
    options.ground.reset();
    const Image without = render(scene, white(), camera, options).radiance;
    float most = 0.0f, least = 1.0f;
    for (std::size_t i = 0; i < with.alpha.size(); ++i) {
        if (without.alpha[i] > 0.0f) continue;
        most = std::max(most, with.alpha[i]);
        least = std::min(least, with.alpha[i]);
    }
    EXPECT_GT(most, 0.5f);
    EXPECT_NEAR(least, 0.0f, 1e-3f);
    options.samples = 1;
    const Image single = render(scene, white(), camera, options).radiance;
    options.ground = -1.0f;
    EXPECT_EQ(render(scene, white(), camera, options).radiance.alpha, single.alpha);
}

TEST(Traced, ClearSolidsInUniformLightAreInvisible) {
    for (const std::string_view shape : shapeNames()) {
        Scene scene = sceneOf(shape, "glass");
        for (Part& part : scene.parts) part.material.sigmaA = glm::vec3(0.0f);
        const Camera camera = framingCamera(scene, 16.0f / 9.0f);
        for (const int budget : {4, 128}) {
            RenderOptions options = tiny(Fidelity::exact);
            options.rayBudget = budget;
            const Rendering rendering = render(scene, white(), camera, options);
            EXPECT_LT(largestDistanceFromOne(rendering.radiance), 1e-5) << shape << " " << budget;
            EXPECT_GE(rendering.rays, 48u * 27u) << shape;
            EXPECT_LE(rendering.rays, 48u * 27u * static_cast<unsigned>(budget)) << shape;
        }
    }
}

TEST(Traced, DoubleIsInvisibleInUniformLightToo) {
    const Rendering rendering =
        render(sceneOf("brilliant", "diamond"), white(), Camera{}, tiny(Fidelity::two));
    EXPECT_LT(largestDistanceFromOne(rendering.radiance), 1e-5);
}

TEST(Traced, ClosedSolidsDoNotLeak) {
    for (const std::string_view shape : {"sphere", "torus-knot", "brilliant"}) {
        const Scene scene = sceneOf(shape, "glass");
        const Rendering rendering =
            render(scene, white(), framingCamera(scene, 16.0f / 9.0f), tiny(Fidelity::exact));
        EXPECT_EQ(rendering.leaks, 0u) << shape;
        EXPECT_EQ(rendering.inconsistencies, 0u) << shape;
    }
}

TEST(Traced, EyesInsideSolidsSeeOut) {
    const Scene scene = sceneOf("sphere", "glass");
    Camera camera;
    camera.eye = {0.2f, 0.1f, 0.3f};
    camera.target = {0.0f, 0.0f, -1.0f};
    const Rendering rendering = render(scene, white(), camera, tiny(Fidelity::exact));
    EXPECT_LT(largestDistanceFromOne(rendering.radiance), 1e-5);
    EXPECT_EQ(rendering.inconsistencies, 0u);
    EXPECT_EQ(rendering.leaks, 0u);
}

TEST(Traced, MatterWithColourTakesLightAlongItsWay) {
    Scene scene = sceneOf("sphere", "glass");
    scene.parts[0].material.eta = glm::vec3(1.0001f);  // straight through
    scene.parts[0].material.sigmaA = {0.2f, 0.5f, 1.0f};
    RenderOptions options = tiny(Fidelity::exact);
    options.width = options.height = 27;
    const Image image = render(scene, white(), Camera{}, options).radiance;
    const glm::vec3 expected = glm::exp(-2.0f * scene.parts[0].material.sigmaA);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(image.at(13, 13)[i], expected[i], 2e-3f);
}

TEST(Traced, GivesCoverageWhereThereIsNoBackground) {
    RenderOptions options = tiny(Fidelity::exact);
    options.background = Background::none;
    options.samples = 16;
    const Image image = render(sceneOf("sphere", "glass"), white(), Camera{}, options).radiance;
    EXPECT_EQ(image.alpha.front(), 0.0f);
    EXPECT_EQ(image.at(0, 0), glm::vec3(0.0f));
    EXPECT_EQ(image.alpha[13 * 48 + 24], 1.0f);
    for (std::size_t i = 0; i < image.alpha.size(); ++i)
        ASSERT_NEAR(image.pixels()[i].x, image.alpha[i], 1e-5f);
}

TEST(Traced, NewMaterialsNeedNoNewScene) {
    const Context context;
    Renderer renderer;
    renderer.setScene(sceneOf("sphere", "glass"));
    renderer.setEnvironment(white());
    FrameOptions options;
    options.picture = tiny(Fidelity::exact);
    renderer.drawFrame(Camera{}, options);
    EXPECT_NEAR(renderer.read().radiance.at(24, 13).x, 1.0f, 1e-5f);
    renderer.setMaterial(0, mirrorMaterial({0.5f, 0.25f, 0.125f}));
    renderer.drawFrame(Camera{}, options);
    const glm::vec3 pixel = renderer.read().radiance.at(24, 13);
    EXPECT_LT(glm::length(pixel - glm::vec3(0.5f, 0.25f, 0.125f)), 1e-5f);
}

TEST(EyeMedia, CountsTheSolidsAroundAPoint) {
    const Scene scene = sceneOf("sphere", "glass");
    Mesh outer = scene.parts[0].mesh;
    for (glm::vec3& position : outer.positions) position *= 2.0f;
    const Mesh* parts[] = {&scene.parts[0].mesh, &outer};
    const Bvh bvh = buildBvh(parts);
    const std::uint32_t media[] = {1u, 2u};
    EXPECT_EQ(mediaAround({0.1f, 0.0f, 0.2f}, bvh, media), 3u);
    EXPECT_EQ(mediaAround({0.0f, 1.5f, 0.0f}, bvh, media), 2u);
    EXPECT_EQ(mediaAround({0.0f, 0.0f, 4.0f}, bvh, media), 0u);
}

}  // namespace
}  // namespace tukor::gl
