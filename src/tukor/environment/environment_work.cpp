#include "tukor/environment/environment_work.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/environment/cube_mips.h"
#include "tukor/environment/environment.h"
#include "tukor/environment/equirect.h"
#include "tukor/environment/layout.h"
#include "tukor/environment/repair.h"
#include "tukor/environment/texture_chain.h"

namespace tukor {

namespace fs = std::filesystem;

namespace {

std::string wordFor(Layout layout) {
    switch (layout) {
        case Layout::equirect:
            return "equirectangular panorama";
        case Layout::hcross:
            return "horizontal cross";
        case Layout::vcross:
            return "vertical cross";
        case Layout::hstrip:
            return "horizontal strip";
        default:
            return "vertical strip";
    }
}

std::optional<Layout> layoutOf(PictureForm form) {
    switch (form) {
        case PictureForm::equirect:
            return Layout::equirect;
        case PictureForm::hcross:
            return Layout::hcross;
        case PictureForm::vcross:
            return Layout::vcross;
        case PictureForm::hstrip:
            return Layout::hstrip;
        case PictureForm::vstrip:
            return Layout::vstrip;
        default:
            return std::nullopt;
    }
}

/// The cube map at a face size, made from the panorama if there is one.
CubeMap cubeOf(const WorkSource& source, std::optional<int> faceSize) {
    if (source.panorama)
        return cubeFromEquirect(*source.panorama,
                                faceSize.value_or(faceSizeForEquirect(source.panorama->width())));
    return faceSize ? resizedCube(*source.cube, *faceSize) : *source.cube;
}

}  // namespace

WorkSource loadWorkSource(const std::string& nameOrPath, std::optional<PictureForm> form) {
    WorkSource source;
    std::error_code error;
    if (!fs::is_regular_file(nameOrPath, error) || (form && *form == PictureForm::faces)) {
        Environment environment = loadEnvironment(nameOrPath);  // built in, six files, or an error
        const bool builtIn =
            nameOrPath.find("{}") == std::string::npos && !fs::exists(nameOrPath, error);
        source.layout = builtIn ? "built in" : "six faces";
        source.width = source.height = environment.radiance.faceSize();
        source.cube = std::move(environment.radiance);
        source.warnings = std::move(environment.warnings);
        return source;
    }
    if (std::optional<TextureFile> texture = loadIfTexture(nameOrPath);
        texture && texture->faces == 6) {
        source.warnings = repairFaces(nameOrPath, *texture);
        source.layout = fmt::format("cube map of {} levels", texture->levels);
        source.width = texture->width;
        source.height = texture->height;
        source.cube = cubeFromTexture(*texture);
        return source;
    }
    Image picture = loadPicture(nameOrPath);
    source.warnings = repairPictures(nameOrPath, std::span(&picture, 1));
    source.width = picture.width();
    source.height = picture.height();
    if (form == PictureForm::octahedral || form == PictureForm::ball) {
        if (picture.width() != picture.height())
            throw Error(
                fmt::format("{}: {} x {} pixels; an octahedral or ball picture must be square",
                            nameOrPath, picture.width(), picture.height()));
        const int faceSize = std::max(1, picture.width() / 2);
        source.layout = form == PictureForm::ball ? "mirror ball" : "octahedral map";
        source.cube = form == PictureForm::ball ? cubeFromBall(picture, faceSize)
                                                : cubeFromOctahedral(picture, faceSize);
        return source;
    }
    const std::optional<Layout> layout = layoutOfShape(picture.width(), picture.height());
    if (layout && form && layout != layoutOf(*form))
        throw Error(
            fmt::format("{}: {} x {} pixels, which is the shape of {}, not of what "
                        "--in-layout says",
                        nameOrPath, picture.width(), picture.height(),
                        (*layout == Layout::equirect ? "an " : "a ") + wordFor(*layout)));
    if (!layout)
        throw Error(
            fmt::format("{}: {} x {} pixels; an equirectangular panorama must be exactly twice "
                        "as wide as high, a cube map a cross of 4 x 3 or 3 x 4 squares or a "
                        "strip of six; octahedral and ball pictures want --in-layout",
                        nameOrPath, picture.width(), picture.height()));
    source.layout = wordFor(*layout);
    if (*layout == Layout::equirect)
        source.panorama = std::move(picture);
    else
        source.cube = cubeFromLayout(picture, *layout);
    return source;
}

void turn(WorkSource& source, double radians) {
    if (std::abs(std::remainder(radians, 2.0 * std::numbers::pi)) < 1e-9) return;
    if (source.panorama) source.panorama = turnedPanorama(*source.panorama, radians);
    if (source.cube) source.cube = turnedCube(*source.cube, radians);
}

const Image& panoramaOf(WorkSource& source) {
    if (!source.panorama)
        source.panorama = panoramaFromCube(*source.cube, 4 * source.cube->faceSize());
    return *source.panorama;
}

Image panoramaOf(WorkSource&& source) {
    (void)panoramaOf(source);
    return std::move(*source.panorama);
}

void checkWorkTarget(const std::string& path, PictureForm form) {
    const bool pattern = path.find("{}") != std::string::npos;
    if (form != PictureForm::faces && pattern)
        throw Error(
            fmt::format("{}: {{}} stands for the face, but this layout is one picture", path));
    if (hasTextureExtension(path)) {
        if (form != PictureForm::faces)
            throw Error(fmt::format(
                "{}: this file type holds the six faces of a cube map; leave out --layout", path));
        if (pattern)
            throw Error(fmt::format(
                "{}: {{}} stands for the face, but this file type holds all six", path));
        return;
    }
    if (form == PictureForm::faces && !pattern)
        throw Error(fmt::format(
            "{}: six faces need a pattern with {{}} for the face, as sky_{{}}.exr", path));
    try {
        checkSavable(path);
    } catch (const Error& error) {
        throw Error(fmt::format("{}, and for cube maps .dds .ktx .ktx2", error.what()));
    }
}

void saveLevels(const std::string& path, std::span<const CubeMap> levels,
                const TextureOptions& options) {
    saveTexture(path, textureFromCubes(levels), options);
}

void saveWork(const std::string& path, WorkSource& source, PictureForm form,
              std::optional<int> size, const SaveOptions& options,
              const TextureOptions& textureOptions) {
    checkWorkTarget(path, form);
    switch (form) {
        case PictureForm::equirect: {
            if (size && *size % 2 != 0)
                throw Error(fmt::format(
                    "{}: a width of {}; a panorama is twice as wide as high, so an even "
                    "number of pixels",
                    path, *size));
            // Pixels are means of 3 x 3 look-ups: enough for texels of half a pixel.
            if (!source.panorama && size && *size < 2 * source.cube->faceSize())
                saveImage(path,
                          panoramaFromCube(shrunkCube(*source.cube, std::max(1, *size / 2)), *size),
                          options);
            else if (!source.panorama && size)
                saveImage(path, panoramaFromCube(*source.cube, *size), options);
            else if (size)
                saveImage(path, resizedPanorama(panoramaOf(source), *size), options);
            else
                saveImage(path, panoramaOf(source), options);
            return;
        }
        case PictureForm::faces: {
            const CubeMap cube = cubeOf(source, size);
            if (hasTextureExtension(path)) {
                std::vector<CubeMap> levels{cube};
                for (CubeMap& mip : cubeMips(cube)) levels.push_back(std::move(mip));
                saveLevels(path, levels, textureOptions);
                return;
            }
            for (const CubeFace face : kCubeFaces) {
                std::string file = path;
                file.replace(file.find("{}"), 2, kFaceNames[0][static_cast<std::size_t>(face)]);
                saveImage(file, pictureOfFace(cube, face), options);
            }
            return;
        }
        case PictureForm::octahedral:
        case PictureForm::ball: {
            // A face of half the edge has about as many texels to the degree.
            const CubeMap cube =
                cubeOf(source, size ? std::optional<int>(std::max(1, *size / 2)) : std::nullopt);
            const int edge = size.value_or(2 * cube.faceSize());
            saveImage(path,
                      form == PictureForm::ball ? ballFromCube(cube, edge)
                                                : octahedralFromCube(cube, edge),
                      options);
            return;
        }
        default:
            saveImage(path, pictureFromCube(cubeOf(source, size), *layoutOf(form)), options);
    }
}

std::string describeWork(WorkSource source) {
    std::string text = fmt::format("layout     {}\nsize       {} x {}\n", source.layout,
                                   source.width, source.height);
    const Image& panorama = panoramaOf(source);
    glm::vec3 least(INFINITY), most(0.0f);
    for (const glm::vec3& pixel : panorama.pixels()) {
        least = glm::min(least, pixel);
        most = glm::max(most, pixel);
    }
    const Spectrum spectrum = spectrumOf(panorama, 8);
    const auto triple = [](glm::dvec3 v) {
        return fmt::format("{:.5g} {:.5g} {:.5g}", v.x, v.y, v.z);
    };
    text += fmt::format("least      {}\nmost       {}\nmean       {}\n", triple(least),
                        triple(most), triple(spectrum.mean));
    const int faceSize =
        source.cube ? source.cube->faceSize() : faceSizeForEquirect(panorama.width());
    text += fmt::format("cube map   {} texels an edge\n", faceSize);
    if (source.warnings.empty()) text += "repaired   nothing\n";
    for (const std::string& warning : source.warnings)
        text += fmt::format("repaired   {}\n", warning);
    if (const std::optional<Sun> sun = findSun(panorama)) {
        constexpr double kDegrees = 180.0 / std::numbers::pi;
        text += fmt::format(
            "sun        towards {}, radius {:.3g} degrees, {:.3g} times the sky around it\n"
            "           irradiance {}\n",
            triple(sun->direction), static_cast<double>(sun->angularRadius) * kDegrees,
            static_cast<double>(sun->brightness), triple(sun->irradiance));
    } else {
        text += "sun        none\n";
    }
    const Harmonics harmonics = harmonicsOf(spectrum, 3);
    for (int l = 0; l < 3; ++l)
        for (int m = -l; m <= l; ++m)
            text += fmt::format(
                "SH {},{:<2}    {}\n", l, m,
                triple(harmonics.coefficients[static_cast<std::size_t>(l * (l + 1) + m)]));
    return text;
}

Image contactSheet(WorkSource source) {
    constexpr int kWidth = 768, kFace = kWidth / 6;
    const CubeMap faces = cubeOf(source, kFace);
    const Image panorama = resizedPanorama(panoramaOf(source), kWidth);
    double mean = 0.0;
    for (const glm::vec3& pixel : panorama.pixels())
        mean += static_cast<double>(pixel.x + pixel.y + pixel.z) / 3.0;
    mean /= static_cast<double>(panorama.pixels().size());
    // The middle exposure brings the mean to 0.18, a photographer's middle grey.
    const auto exposure = static_cast<float>(mean > 0.0 ? 0.18 / mean : 1.0);
    Image sheet(kWidth, 3 * kWidth / 2 + kFace);
    for (int strip = 0; strip < 3; ++strip)
        for (int row = 0; row < kWidth / 2; ++row)
            for (int column = 0; column < kWidth; ++column)
                sheet.at(column, strip * kWidth / 2 + row) =
                    exposure * std::exp2(2.0f * static_cast<float>(strip - 1)) *
                    panorama.at(column, row);
    const Image below = pictureFromCube(faces, Layout::hstrip);
    for (int row = 0; row < kFace; ++row)
        for (int column = 0; column < kWidth; ++column)
            sheet.at(column, 3 * kWidth / 2 + row) = exposure * below.at(column, row);
    return sheet;
}

}  // namespace tukor
