// What each program sees where, in pictures whose directions are coded as colours. The programs'
// own formulas are written out here once more: from three.js's shaders, Cycles, cmgen, Unreal's
// texture compressor and OpenEXR's library, whose functions are called.
#include "tukor/environment/orientation.h"

#include <cmath>
#include <numbers>

#include <OpenEXR/ImfEnvmap.h>
#include <gtest/gtest.h>

#include "tukor/base/error.h"
#include "tukor/base/test_folder.h"
#include "tukor/environment/environment_work.h"
#include "tukor/environment/equirect.h"
#include "tukor/environment/panorama.h"

namespace tukor {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

glm::vec3 colour(glm::vec3 direction) {
    return 0.5f + 0.5f * glm::normalize(direction);
}

/// A world whose every direction is its colour.
CubeMap colouredCube(int faceSize) {
    CubeMap cube(faceSize);
    for (const CubeFace face : kCubeFaces)
        for (int i = 0; i < faceSize * faceSize; ++i) {
            const auto place = [&](int k) {
                return (2.0f * static_cast<float>(k) + 1.0f) / static_cast<float>(faceSize) - 1.0f;
            };
            cube.texels(face)[static_cast<std::size_t>(i)] =
                colour(directionFromCube({face, place(i % faceSize), place(i / faceSize)}));
        }
    return cube;
}

Image colouredPanorama(int width) {
    Image image(width, width / 2);
    for (int row = 0; row < image.height(); ++row)
        for (int column = 0; column < width; ++column)
            image.at(column, row) = colour(directionFromEquirect((glm::vec2(column, row) + 0.5f) /
                                                                 glm::vec2(width, image.height())));
    return image;
}

/// glTF's axes from a program's.
glm::vec3 fromZUp(glm::vec3 d) {  // Blender: right-handed
    return {d.x, d.z, -d.y};
}
glm::vec3 fromUnreal(glm::vec3 d) {  // left-handed
    return {d.x, d.z, d.y};
}

/// The direction, in glTF's axes, in which a program sees a place of its panorama.
glm::vec3 seenAt(Orientation program, glm::vec2 place) {
    const float u = place.x, v = place.y;
    const float polar = kPi * v, across = std::sin(polar), up = std::cos(polar);
    switch (program) {
        case Orientation::blender: {  // u = -atan2(y, x) / 2pi + 1/2
            const float phi = -2.0f * kPi * (u - 0.5f);
            return fromZUp({across * std::cos(phi), across * std::sin(phi), up});
        }
        case Orientation::three: {  // u = atan(z, x) / 2pi + 1/2
            const float phi = 2.0f * kPi * (u - 0.5f);
            return {across * std::cos(phi), up, across * std::sin(phi)};
        }
        case Orientation::openexr: {
            // The library puts the first and the last pixel's middles on the same meridian.
            const Imath::Box2i window({0, 0}, {1000000, 500000});
            const Imath::V3f d = Imf::LatLongMap::direction(window, {u * 1e6f, v * 5e5f});
            return {d.x, d.y, d.z};
        }
        case Orientation::filament: {  // x = atan2(x, z) / pi, mirrored in x afterwards
            const float phi = 2.0f * kPi * (u - 0.5f);
            return {-across * std::sin(phi), up, across * std::cos(phi)};
        }
        case Orientation::unreal: {  // u = (1 + atan2(x, -y) / pi) / 2 in its axes
            const float phi = 2.0f * kPi * (u - 0.5f);
            return fromUnreal({across * std::sin(phi), -across * std::cos(phi), up});
        }
        default:
            return directionFromEquirect(place);
    }
}

/// The direction in which a program sees a place on a face of its cube map.
glm::vec3 seenAt(Orientation program, CubePoint point) {
    const glm::vec3 d = directionFromCube(point);  // as the hardware looks up
    switch (program) {
        case Orientation::three:
            return {-d.x, d.y, d.z};
        case Orientation::unreal:
            return fromUnreal(d);
        case Orientation::openexr: {
            const Imath::Box2i window({0, 0}, {1023, 6 * 1024 - 1});
            const auto face = static_cast<Imf::CubeMapFace>(point.face);
            // The library goes from places in its faces to pixels; here, back.
            const auto pixel = [&](float x, float y) {
                return Imf::CubeMap::pixelPosition(face, window, {x, y});
            };
            const Imath::V2f origin = pixel(0, 0);
            const Imath::V2f away =
                Imath::V2f(0.5f * (point.s + 1.0f) * 1023.0f,
                           0.5f * (point.t + 1.0f) * 1023.0f + 1024.0f * static_cast<float>(face)) -
                origin;
            const Imath::V3f e = Imf::CubeMap::direction(
                face, window, {away.dot(pixel(1, 0) - origin), away.dot(pixel(0, 1) - origin)});
            return {e.x, e.y, e.z};
        }
        default:
            return d;
    }
}

class Oriented : public testing::TestWithParam<Orientation> {
protected:
    [[nodiscard]] std::string path(const std::string& name) const { return folder_.path(name); }

    /// Saves for the program and gives what is in the file, without asking for its orientation.
    WorkSource stored(const WorkSource& world, const std::string& name, PictureForm form) const {
        saveWork(path(name), world,
                 {.form = form, .to = GetParam(), .texture = {TexelFormat::rgba32f}});
        const bool texture = name.find(".exr") == std::string::npos;
        return loadWorkSource(path(name), texture ? std::optional<PictureForm>() : form);
    }

private:
    TestFolder folder_;
};

constexpr std::pair<PictureForm, const char*> kCubeFiles[] = {
    {PictureForm::faces, "face_{}.exr"}, {PictureForm::hcross, "hcross.exr"},
    {PictureForm::vcross, "vcross.exr"}, {PictureForm::hstrip, "hstrip.exr"},
    {PictureForm::vstrip, "vstrip.exr"}, {PictureForm::faces, "cube.ktx2"},
    {PictureForm::faces, "cube.ktx"},    {PictureForm::faces, "cube.dds"}};

TEST_P(Oriented, PanoramasShowEveryDirectionWhereTheProgramSeesIt) {
    WorkSource world;
    world.panorama = colouredPanorama(256);
    const WorkSource file = stored(world, "panorama.exr", PictureForm::equirect);
    const Image& image = *file.panorama;
    for (int row = 0; row < image.height(); ++row)
        for (int column = 0; column < image.width(); ++column) {
            const glm::vec2 place = (glm::vec2(column, row) + 0.5f) / glm::vec2(256, 128);
            // OpenEXR's formula works in single precision about integers of a million.
            ASSERT_LT(glm::length(image.at(column, row) - colour(seenAt(GetParam(), place))), 2e-5f)
                << column << " " << row;
        }
}

TEST_P(Oriented, CubeMapsShowEveryDirectionWhereTheProgramSeesIt) {
    WorkSource world;
    world.cube = colouredCube(16);
    for (const auto& [form, name] : kCubeFiles) {
        const WorkSource file = stored(world, name, form);
        for (const CubeFace face : kCubeFaces)
            for (int i = 0; i < 16 * 16; ++i) {
                const CubePoint point{face, static_cast<float>(2 * (i % 16) - 15) / 16.0f,
                                      static_cast<float>(2 * (i / 16) - 15) / 16.0f};
                ASSERT_LT(glm::length(file.cube->texels(face)[static_cast<std::size_t>(i)] -
                                      colour(seenAt(GetParam(), point))),
                          1e-5f)
                    << name << " face " << static_cast<int>(face) << " texel " << i;
            }
    }
}

TEST_P(Oriented, ThereAndBackIsTheIdentity) {
    WorkSource world;
    world.cube = colouredCube(16);
    for (const auto& [form, name] : kCubeFiles) {
        (void)stored(world, name, form);
        const bool texture = std::string(name).find(".exr") == std::string::npos;
        const WorkSource back =
            loadWorkSource(path(name), texture ? std::optional<PictureForm>() : form, GetParam());
        for (const CubeFace face : kCubeFaces)
            EXPECT_TRUE(std::equal(back.cube->texels(face).begin(), back.cube->texels(face).end(),
                                   world.cube->texels(face).begin()))
                << name;
    }
    WorkSource panorama;
    panorama.panorama = colouredPanorama(64);
    (void)stored(panorama, "panorama.exr", PictureForm::equirect);
    const WorkSource back = loadWorkSource(path("panorama.exr"), std::nullopt, GetParam());
    EXPECT_TRUE(std::equal(back.panorama->pixels().begin(), back.panorama->pixels().end(),
                           panorama.panorama->pixels().begin()));
}

/// A panorama for the program, and the cube map made of it for the program, are one world.
TEST_P(Oriented, PanoramasAndCubeMapsOfAProgramAgree) {
    WorkSource world;
    world.panorama = colouredPanorama(256);
    (void)stored(world, "panorama.exr", PictureForm::equirect);
    const WorkSource file = loadWorkSource(path("panorama.exr"), std::nullopt, GetParam());
    saveWork(path("cube.ktx2"), file,
             {.form = PictureForm::faces, .to = GetParam(), .texture = {TexelFormat::rgba32f}});
    const WorkSource cube = loadWorkSource(path("cube.ktx2"), std::nullopt);
    for (const CubeFace face : kCubeFaces) {
        const CubePoint middle{face, 0.3f, -0.4f};
        EXPECT_LT(glm::length(cube.cube->radiance(directionFromCube(middle)) -
                              colour(seenAt(GetParam(), middle))),
                  0.01f);
    }
}

INSTANTIATE_TEST_SUITE_P(
    EveryProgram, Oriented,
    testing::Values(Orientation::opengl, Orientation::blender, Orientation::three,
                    Orientation::openexr, Orientation::filament, Orientation::unreal),
    [](const auto& program) {
        return std::string(kOrientationSpellings[static_cast<std::size_t>(program.param)].second);
    });

TEST(LoadWorkSource, DoesNotOrientWhatIsBuiltIn) {
    EXPECT_THROW((void)loadWorkSource("studio", std::nullopt, Orientation::three), Error);
}

TEST(TurnedCube, MovesTexelsWholeByQuarters) {
    const CubeMap cube = colouredCube(8);
    CubeMap turned = cube;
    for (int i = 0; i < 4; ++i) turned = turnedCube(turned, 0.5 * std::numbers::pi);
    for (const CubeFace face : kCubeFaces)
        EXPECT_TRUE(std::equal(cube.texels(face).begin(), cube.texels(face).end(),
                               turned.texels(face).begin()));
    // A quarter turn takes +X to -Z.
    const CubeMap quarter = turnedCube(cube, -1.5 * std::numbers::pi);
    EXPECT_LT(glm::length(quarter.radiance({0.1f, 0.2f, -1.0f}) - colour({1.0f, 0.2f, 0.1f})),
              0.01f);
}

}  // namespace
}  // namespace tukor
