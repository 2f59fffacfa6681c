// Through every layout, file type and texel format and back: what is lost is the format's
// precision.
#include <cmath>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tukor/base/test_folder.h"
#include "tukor/environment/environment_work.h"
#include "tukor/environment/texture_chain.h"
#include "tukor/image/display.h"

namespace tukor {
namespace {

/// A file type with its options, and how far a value v of up to `most` may be from what was saved.
struct Format {
    const char* extension;
    SaveOptions picture;
    TextureOptions texture;
    float relative;  // of v
    float ofMost;    // of the largest component
    float absolute;
    const char* name;

    [[nodiscard]] bool isTexture() const {
        return hasTextureExtension(std::string("a") + extension);
    }
    friend void PrintTo(const Format& format, std::ostream* out) { *out << format.name; }
};

std::vector<Format> formats() {
    std::vector<Format> all;
    const auto picture = [&](const char* extension, SaveOptions options, float relative,
                             float ofMost, float absolute, const char* name) {
        all.push_back({extension, std::move(options), {}, relative, ofMost, absolute, name});
    };
    picture(".exr", {}, 0.0f, 0.0f, 0.0f, "ExrFull");
    SaveOptions half;
    half.exrPixels = ExrPixels::half;
    picture(".exr", half, 1.0f / 2048, 0.0f, 0.0f, "ExrHalf");
    picture(".hdr", {}, 0.0f, 1.0f / 128, 0.0f, "Hdr");  // truncated to 8 bits of the largest
    picture(".png", {}, 0.0f, 0.0f, 0.0051f, "Png8");    // half a code where sRGB is steepest
    SaveOptions deep;
    deep.pngDepth = PngDepth::bits16;
    picture(".png", deep, 0.0f, 0.0f, 2.5e-5f, "Png16");
    SaveOptions fine;
    fine.jpegQuality = 100;
    picture(".jpg", fine, 0.0f, 0.0f, 0.03f, "Jpeg");  // chroma at half the resolution
    const std::pair<TexelFormat, std::array<float, 3>> texels[] = {
        {TexelFormat::rgba32f, {0.0f, 0.0f, 0.0f}},
        {TexelFormat::rgba16f, {1.0f / 2048, 0.0f, 0.0f}},
        {TexelFormat::rgb9e5, {0.0f, 1.0f / 512, 0.0f}},
        {TexelFormat::r11g11b10f, {1.0f / 64, 0.0f, 0.0f}},
        {TexelFormat::rgba8, {0.0f, 0.0f, 0.0051f}},
        // A block spans an eighth of a radian, over which these change by at most 0.15: a 14th of
        // that to the nearest of eight indices, and half of a step of ends of 10 bits, 1.6 %.
        {TexelFormat::bc6h, {0.016f, 0.0f, 0.011f}}};
    constexpr const char* kNames[][6] = {
        {"DdsFloat", "DdsHalf", "DdsRgb9e5", "DdsR11", "DdsRgba8", "DdsBc6h"},
        {"KtxFloat", "KtxHalf", "KtxRgb9e5", "KtxR11", "KtxRgba8", "KtxBc6h"},
        {"Ktx2Float", "Ktx2Half", "Ktx2Rgb9e5", "Ktx2R11", "Ktx2Rgba8", "Ktx2Bc6h"},
        {"Ktx2ZstdFloat", "Ktx2ZstdHalf", "Ktx2ZstdRgb9e5", "Ktx2ZstdR11", "Ktx2ZstdRgba8",
         "Ktx2ZstdBc6h"}};
    for (std::size_t file = 0; file < 4; ++file)
        for (std::size_t i = 0; i < 6; ++i) {
            const auto& [format, errors] = texels[i];
            all.push_back({std::array{".dds", ".ktx", ".ktx2", ".ktx2"}[file],
                           {},
                           {format, file == 3 ? Supercompression::zstd : Supercompression::none},
                           errors[0],
                           errors[1],
                           errors[2],
                           kNames[file][i]});
        }
    return all;
}

/// Smooth, and in [0.1, 0.9] so that PNG and JPEG hold it too.
CubeMap landscape(int faceSize) {
    CubeMap cube(faceSize);
    for (const CubeFace face : kCubeFaces)
        for (int i = 0; i < faceSize * faceSize; ++i) {
            const glm::vec3 d = glm::normalize(directionFromCube(
                {face, (2.0f * static_cast<float>(i % faceSize) + 1) / float(faceSize) - 1,
                 (2.0f * static_cast<float>(i / faceSize) + 1) / float(faceSize) - 1}));
            cube.texels(face)[static_cast<std::size_t>(i)] =
                0.5f + 0.2f * d + 0.2f * glm::vec3(d.y * d.z, d.z * d.x, d.x * d.y);
        }
    return cube;
}

class RoundTrip : public testing::TestWithParam<Format> {
protected:
    /// Saves the cube in a layout, loads it, and compares texel by texel.
    void expectBack(const CubeMap& cube, PictureForm form, std::optional<int> size, float blur) {
        const Format& format = GetParam();
        const bool faces = form == PictureForm::faces && !format.isTexture();
        const std::string path =
            folder_.path(fmt::format("a{}{}", faces ? "_{}" : "", format.extension));
        WorkSource source;
        source.cube = cube;
        saveWork(path, source, {form, size, Orientation::opengl, format.picture, format.texture});
        WorkSource back =
            loadWorkSource(path, format.isTexture() ? std::optional<PictureForm>() : form);
        EXPECT_TRUE(back.warnings.empty());
        if (!back.cube) {
            const std::string again = folder_.path("again_{}.exr");
            saveWork(again, back, {PictureForm::faces, cube.faceSize()});
            back = loadWorkSource(again, PictureForm::faces);
        }
        ASSERT_EQ(back.cube->faceSize(), cube.faceSize());
        for (const CubeFace face : kCubeFaces)
            for (std::size_t i = 0; i < cube.texels(face).size(); ++i) {
                const glm::vec3 was = cube.texels(face)[i], is = back.cube->texels(face)[i];
                const float most = std::max({was.x, was.y, was.z});
                for (int c = 0; c < 3; ++c)
                    ASSERT_NEAR(
                        is[c], was[c],
                        format.relative * was[c] + format.ofMost * most + format.absolute + blur)
                        << "form " << int(form) << " face " << int(face) << " texel " << i;
            }
    }

    TestFolder folder_;
};

TEST_P(RoundTrip, BringsEveryLayoutBack) {
    const CubeMap cube = landscape(32);
    if (GetParam().isTexture()) return expectBack(cube, PictureForm::faces, std::nullopt, 0.0f);
    for (const PictureForm form : {PictureForm::faces, PictureForm::hcross, PictureForm::vcross,
                                   PictureForm::hstrip, PictureForm::vstrip})
        expectBack(cube, form, std::nullopt, 0.0f);
    // These are resampled, there and back: a quarter of a texel (1 / 64 of a radian) of linear
    // interpolation where the landscape changes by at most 0.6 a radian.
    expectBack(cube, PictureForm::equirect, 128, 0.01f);
    expectBack(cube, PictureForm::octahedral, 64, 0.02f);
}

INSTANTIATE_TEST_SUITE_P(EveryFormat, RoundTrip, testing::ValuesIn(formats()),
                         [](const auto& format) { return std::string(format.param.name); });

/// Six pixels long.
Image waves(int width) {
    Image image(width, width / 2);
    for (int row = 0; row < width / 2; ++row)
        for (int column = 0; column < width; ++column)
            image.at(column, row) =
                glm::vec3(0.5f + 0.3f * std::sin(1.0472f * static_cast<float>(column + row)));
    return image;
}

/// Every pixel of its own, and some lamps a thousand times brighter.
Image leaves(int width) {
    Image image(width, width / 2);
    std::mt19937 random(3);
    std::uniform_real_distribution<float> even(0.05f, 0.9f);
    for (glm::vec3& pixel : image.pixels()) pixel = {even(random), even(random), even(random)};
    for (int i = 0; i < 5; ++i) image.at(width / 5 * i + 3, width / 8 + 3 * i) = glm::vec3(300.0f);
    return image;
}

/// There and back, to the nearest code of eight bits or the next within 60 degrees of the horizon:
/// nearer to the poles pixels become smaller than texels.
void expectBackToEightBits(PictureForm form, int size) {
    constexpr int kWidth = 96;
    const TestFolder folder;
    const std::string path = folder.path(form == PictureForm::faces ? "there_{}.exr" : "there.exr");
    const Image before = leaves(kWidth);
    WorkSource source;
    source.panorama = before;
    saveWork(path, source, {form, size});
    saveWork(folder.path("back.exr"), loadWorkSource(path, form), {PictureForm::equirect, kWidth});
    const Image back = loadPicture(folder.path("back.exr"));
    for (int row = kWidth / 12; row < kWidth / 2 - kWidth / 12; ++row)
        for (int column = 0; column < kWidth; ++column)
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(srgb8(back.at(column, row)[c]), srgb8(before.at(column, row)[c]), 1)
                    << column << ", " << row;
}

TEST(RoundTripFaces, TwiceAsFineBringsThePanoramaBack) {
    expectBackToEightBits(PictureForm::faces, 96);
    expectBackToEightBits(PictureForm::faces, 192);
}

TEST(RoundTripOctahedral, TwiceAsFineBringsThePanoramaBack) {
    expectBackToEightBits(PictureForm::octahedral, 192);
    expectBackToEightBits(PictureForm::octahedral, 384);
}

TEST(RoundTripPanorama, OfAnyLargerSizeBringsThePanoramaBack) {
    expectBackToEightBits(PictureForm::equirect, 144);
    expectBackToEightBits(PictureForm::equirect, 288);
}

TEST(RoundTripFaces, MuchFinerThanThePanoramaBringItBack) {
    const TestFolder folder;
    const std::string faces = folder.path("a_{}.exr"), panorama = folder.path("a.exr");
    const Image before = waves(48);
    WorkSource source;
    source.panorama = before;
    saveWork(faces, source, {PictureForm::faces, 96});
    saveWork(panorama, loadWorkSource(faces, PictureForm::faces), {PictureForm::equirect, 48});
    const Image back = loadPicture(panorama);
    for (int row = 4; row < 20; ++row)  // means over areas alone would lose a fifth of the waves
        for (int column = 0; column < 48; ++column)
            EXPECT_NEAR(back.at(column, row).x, before.at(column, row).x, 0.02f)
                << column << ", " << row;
}

TEST(RoundTripOctahedral, BringsAPanoramaBack) {
    const TestFolder folder;
    const std::string path = folder.path("a.exr");
    const Image before = waves(96);
    WorkSource source;
    source.panorama = before;
    saveWork(path, source, {PictureForm::octahedral, 96});
    saveWork(path, loadWorkSource(path, PictureForm::octahedral), {PictureForm::equirect, 96});
    const Image back = loadPicture(path);
    for (int row = 8; row < 40; ++row)  // looked up twice between texels they lose a third
        for (int column = 0; column < 96; ++column)
            EXPECT_NEAR(back.at(column, row).x, before.at(column, row).x, 0.03f)
                << column << ", " << row;
}

TEST(RoundTripBall, BringsAllBackButWhatTheBallHides) {
    const TestFolder folder;
    const std::string path = folder.path("a.exr");
    WorkSource source;
    source.cube = landscape(32);
    saveWork(path, source, {PictureForm::ball, 512});
    const WorkSource back = loadWorkSource(path, PictureForm::ball);
    for (int i = 0; i < 200; ++i) {
        const float y = 0.99f - 0.0099f * static_cast<float>(i), phi = 2.4f * static_cast<float>(i);
        const float across = std::sqrt(1 - y * y);
        const glm::vec3 d(across * std::cos(phi), y, across * std::sin(phi));
        if (d.z < -0.95f) continue;  // behind the ball: at its rim a pixel spans degrees
        EXPECT_LT(glm::length(back.cube->radiance(d) - source.cube->radiance(d)), 0.01f) << i;
    }
}

}  // namespace
}  // namespace tukor
