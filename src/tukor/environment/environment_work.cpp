#include "tukor/environment/environment_work.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/base/file.h"
#include "tukor/environment/cube_mips.h"
#include "tukor/environment/environment.h"
#include "tukor/environment/equirect.h"
#include "tukor/environment/layout.h"
#include "tukor/environment/panorama.h"
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

/// The layout that a picture's shape gives it and `form`, if any, agrees with. Throws Error.
Layout layoutOfPicture(const std::string& name, const Image& picture,
                       std::optional<PictureForm> form) {
    const std::optional<Layout> layout = layoutOfShape(picture.width(), picture.height());
    if (layout && form && layout != layoutOf(*form))
        throw Error(
            fmt::format("{}: {} x {} pixels, which is the shape of {}, not of what "
                        "--in-layout says",
                        name, picture.width(), picture.height(),
                        (*layout == Layout::equirect ? "an " : "a ") + wordFor(*layout)));
    if (!layout)
        throw Error(
            fmt::format("{}: {} x {} pixels; an equirectangular panorama must be exactly twice "
                        "as wide as high, a cube map a cross of 4 x 3 or 3 x 4 squares or a "
                        "strip of six; octahedral and ball pictures want --in-layout",
                        name, picture.width(), picture.height()));
    return *layout;
}

/// The cube map at a face size, made from the panorama if there is one.
CubeMap cubeOf(WorkSource&& source, std::optional<int> faceSize, const Progress& progress) {
    if (source.panorama)
        return cubeFromEquirect(*source.panorama,
                                faceSize.value_or(faceSizeForEquirect(source.panorama->width())),
                                progress);
    return faceSize ? resizedCube(*source.cube, *faceSize) : std::move(*source.cube);
}

/// The panorama at a width, made from the cube map if there is nothing else.
Image panoramaAt(WorkSource&& source, std::optional<int> width, const Progress& progress) {
    if (source.panorama)
        return width ? resizedPanorama(*source.panorama, *width, progress)
                     : std::move(*source.panorama);
    const CubeMap& cube = *source.cube;
    const int to = width.value_or(4 * cube.faceSize());
    // Of squares much finer than the panorama means are enough: those of the cube map.
    if (source.square && 2 * to >= cube.faceSize())
        return source.ball ? panoramaFromBall(*source.square, to, progress)
                           : panoramaFromOctahedral(*source.square, to, progress);
    // Pixels are such that looking up between them gives what the cube map shows: a panorama that
    // was made into faces comes back.
    return panoramaWithMeansOf(cube, to, progress);
}

}  // namespace

WorkSource loadWorkSource(const std::string& nameOrPath, std::optional<PictureForm> form,
                          Orientation from) {
    WorkSource source;
    std::error_code error;
    const auto takeCube = [&](CubeMap cube) {
        source.cube =
            from == Orientation::opengl ? std::move(cube) : worldCube(cube, cubeAxesOf(from));
    };
    if (!fs::is_regular_file(nameOrPath, error) || (form && *form == PictureForm::faces)) {
        Environment environment = loadEnvironment(nameOrPath);  // built in, six files, or an error
        const bool builtIn =
            nameOrPath.find("{}") == std::string::npos && !fs::exists(nameOrPath, error);
        if (builtIn && from != Orientation::opengl)
            throw Error(fmt::format(
                "{}: built in, so --from has nothing to say about it; turn it by --rotate",
                nameOrPath));
        source.layout = builtIn ? "built in" : "six faces";
        source.width = source.height = environment.radiance.faceSize();
        takeCube(std::move(environment.radiance));
        source.warnings = std::move(environment.warnings);
        return source;
    }
    if (std::optional<TextureFile> texture = loadIfTexture(nameOrPath);
        texture && texture->faces == 6) {
        source.warnings = repairFaces(nameOrPath, *texture);
        source.layout = fmt::format("cube map of {} levels", texture->levels);
        source.width = texture->width;
        source.height = texture->height;
        takeCube(cubeFromTexture(*texture));
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
        source.ball = form == PictureForm::ball;
        source.cube =
            source.ball ? cubeFromBall(picture, faceSize) : cubeFromOctahedral(picture, faceSize);
        source.square = std::move(picture);
        return source;
    }
    const Layout layout = layoutOfPicture(nameOrPath, picture, form);
    source.layout = wordFor(layout);
    if (layout == Layout::equirect) {
        source.panorama = std::move(picture);
        turn(source, turnFrom(from));
    } else {
        takeCube(cubeFromLayout(picture, layout));
    }
    return source;
}

void turn(WorkSource& source, double radians) {
    if (std::abs(std::remainder(radians, 2.0 * std::numbers::pi)) < 1e-9) return;
    if (source.panorama) source.panorama = turnedPanorama(*source.panorama, radians);
    if (source.cube) source.cube = turnedCube(*source.cube, radians);
    source.square.reset();
}

void expose(WorkSource& source, float stops) {
    if (stops == 0.0f) return;
    const float factor = std::exp2(stops);
    const auto scale = [factor](std::span<glm::vec3> texels) {
        for (glm::vec3& texel : texels) texel *= factor;
    };
    if (source.panorama) scale(source.panorama->pixels());
    if (source.square) scale(source.square->pixels());
    if (!source.cube) return;
    for (const CubeFace face : kCubeFaces) scale(source.cube->texels(face));
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

std::vector<EncodedFile> encodeLevels(const std::string& path, std::span<const CubeMap> levels,
                                      const WorkTarget& target, const Progress& progress) {
    const auto encoded = [&](std::span<const CubeMap> stored) {
        std::vector<EncodedFile> files;
        auto bytes =
            encodeTexture(textureFromCubes(stored), lowerExtension(path), target.texture, progress);
        if (bytes.empty()) return files;
        Clipping clipping{largestOf(target.texture.texels)};
        if (std::isfinite(clipping.most))
            for (const CubeFace face : kCubeFaces)
                addClipping(clipping, pictureOfFace(stored.front(), face), PixelAreas::face);
        files.push_back({path, std::move(bytes), clipping});
        return files;
    };
    if (target.to == Orientation::opengl) return encoded(levels);
    std::vector<CubeMap> stored;
    stored.reserve(levels.size());
    for (const CubeMap& level : levels) stored.push_back(storedCube(level, cubeAxesOf(target.to)));
    return encoded(stored);
}

std::vector<EncodedFile> encodeWork(const std::string& path, WorkSource source,
                                    const WorkTarget& target, const Progress& progress) {
    checkWorkTarget(path, target.form);
    bool stopped = false;  // once asked to, whoever asks next
    const Progress watch = [&](float fraction) {
        stopped = stopped || (progress && !progress(fraction));
        return !stopped;
    };
    const Progress making = partOf(watch, 0.0f, 0.5f), encoding = partOf(watch, 0.5f, 1.0f);
    std::vector<EncodedFile> files;
    const auto add = [&](const std::string& file, const Image& image, const Progress& part) {
        if (stopped) return;
        const std::string extension = lowerExtension(file);
        Clipping clipping{largestOf(TexelFormat::rgba16f)};
        if (extension == ".exr" && target.picture.exrPixels == ExrPixels::half)
            addClipping(clipping, image,
                        target.form == PictureForm::equirect ? PixelAreas::equirect
                        : target.form == PictureForm::faces  ? PixelAreas::face
                                                             : PixelAreas::equal);
        files.push_back({file, encodeImage(image, extension, target.picture, part), clipping});
    };
    const std::optional<int> size = target.size;
    switch (target.form) {
        case PictureForm::equirect:
            if (size && *size % 2 != 0)
                throw Error(fmt::format(
                    "{}: a width of {}; a panorama is twice as wide as high, so an even "
                    "number of pixels",
                    path, *size));
            turn(source, -turnFrom(target.to));
            add(path, panoramaAt(std::move(source), size, making), encoding);
            break;
        case PictureForm::octahedral:
        case PictureForm::ball: {
            // A face of half the edge has about as many texels to the degree; one of a panorama
            // is made finer, so that it is not blurred twice.
            const int edge =
                size.value_or(2 * (source.panorama ? faceSizeForEquirect(source.panorama->width())
                                                   : source.cube->faceSize()));
            const int faces = source.panorama ? facesBeside(edge) : std::max(1, edge / 2);
            const CubeMap cube = cubeOf(std::move(source), faces, making);
            add(path,
                target.form == PictureForm::ball ? ballFromCube(cube, edge)
                                                 : octahedralFromCube(cube, edge),
                encoding);
            break;
        }
        default: {
            CubeMap cube = cubeOf(std::move(source), size, making);
            if (target.form == PictureForm::faces && hasTextureExtension(path)) {
                if (stopped) return {};
                std::vector<CubeMap> levels{std::move(cube)};
                for (CubeMap& mip : cubeMips(levels.front())) levels.push_back(std::move(mip));
                if (!watch(0.5f)) return {};
                return encodeLevels(path, levels, target, encoding);
            }
            if (target.to != Orientation::opengl) cube = storedCube(cube, cubeAxesOf(target.to));
            if (target.form != PictureForm::faces) {
                add(path, pictureFromCube(cube, *layoutOf(target.form)), encoding);
                break;
            }
            for (const CubeFace face : kCubeFaces) {
                const auto i = static_cast<std::size_t>(face);
                std::string file = path;
                file.replace(file.find("{}"), 2, kFaceNames[0][i]);
                const auto part = static_cast<float>(i);
                add(file, pictureOfFace(cube, face),
                    partOf(encoding, part / 6.0f, (part + 1.0f) / 6.0f));
            }
        }
    }
    if (!watch(1.0f)) return {};
    return files;
}

void writeFiles(std::span<const EncodedFile> files) {
    for (const EncodedFile& file : files) writeFile(file.path, file.bytes);
}

bool saveWork(const std::string& path, WorkSource source, const WorkTarget& target,
              const Progress& progress) {
    // All is encoded before anything is written, so that nothing is left of what was stopped.
    const std::vector<EncodedFile> files = encodeWork(path, std::move(source), target, progress);
    writeFiles(files);
    return !files.empty();
}

}  // namespace tukor
