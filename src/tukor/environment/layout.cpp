#include "tukor/environment/layout.h"

#include <algorithm>
#include <cctype>
#include <vector>

#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/base/file.h"

namespace tukor {

namespace fs = std::filesystem;

namespace {

/// Where the faces stand, in units of a face; `turned` ones are rotated by 180 degrees.
struct Placement {
    int columns, rows;
    std::array<glm::ivec2, 6> faces;
    std::optional<CubeFace> turned;
};

const Placement& placementOf(Layout layout) {
    static const Placement hcross{4, 3, {{{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {3, 1}}}, {}};
    static const Placement vcross{
        3, 4, {{{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {1, 3}}}, CubeFace::negZ};
    static const Placement hstrip{6, 1, {{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {5, 0}}}, {}};
    static const Placement vstrip{1, 6, {{{0, 0}, {0, 1}, {0, 2}, {0, 3}, {0, 4}, {0, 5}}}, {}};
    switch (layout) {
        case Layout::hcross:
            return hcross;
        case Layout::vcross:
            return vcross;
        case Layout::hstrip:
            return hstrip;
        default:
            return vstrip;
    }
}

bool isPicture(const fs::path& path) {
    const std::string extension = lowerExtension(path);
    return extension == ".exr" || extension == ".hdr" || extension == ".pic" ||
           extension == ".png" || extension == ".jpg" || extension == ".jpeg";
}

/// Whether a file is called `name`, alone or after a separator: `px.hdr`, `sky_px.hdr`.
bool isCalled(const fs::path& path, std::string_view name) {
    std::string stem = path.stem().string();
    std::transform(stem.begin(), stem.end(), stem.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (stem.size() < name.size() || !stem.ends_with(name)) return false;
    return stem.size() == name.size() ||
           !std::isalnum(static_cast<unsigned char>(stem[stem.size() - name.size() - 1]));
}

std::string listOf(const std::array<std::string_view, 6>& names) {
    return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

std::optional<Layout> layoutOfShape(int width, int height) noexcept {
    if (width == 2 * height) return Layout::equirect;
    for (const Layout layout : {Layout::hcross, Layout::vcross, Layout::hstrip, Layout::vstrip}) {
        const Placement& placement = placementOf(layout);
        if (width % placement.columns == 0 && height % placement.rows == 0 &&
            width / placement.columns == height / placement.rows)
            return layout;
    }
    return std::nullopt;
}

CubeMap cubeFromLayout(const Image& picture, Layout layout) {
    const Placement& placement = placementOf(layout);
    const int size = picture.width() / placement.columns;
    TUKOR_ASSERT(layout != Layout::equirect && size * placement.columns == picture.width() &&
                 size * placement.rows == picture.height());
    CubeMap cube(size);
    for (const CubeFace face : kCubeFaces) {
        const glm::ivec2 origin = size * placement.faces[static_cast<std::size_t>(face)];
        const std::span<glm::vec3> texels = cube.texels(face);
        for (int row = 0; row < size; ++row)
            std::copy_n(&picture.at(origin.x, origin.y + row), size,
                        &texels[static_cast<std::size_t>(row) * static_cast<std::size_t>(size)]);
        if (placement.turned == face) std::reverse(texels.begin(), texels.end());
    }
    return cube;
}

Image pictureOfFace(const CubeMap& cube, CubeFace face) {
    Image picture(cube.faceSize(), cube.faceSize());
    const std::span<const glm::vec3> texels = cube.texels(face);
    std::copy(texels.begin(), texels.end(), picture.pixels().begin());
    return picture;
}

Image pictureFromCube(const CubeMap& cube, Layout layout) {
    TUKOR_ASSERT(layout != Layout::equirect);
    const Placement& placement = placementOf(layout);
    const int size = cube.faceSize();
    Image picture(size * placement.columns, size * placement.rows);
    for (const CubeFace face : kCubeFaces) {
        Image one = pictureOfFace(cube, face);
        if (placement.turned == face) std::reverse(one.pixels().begin(), one.pixels().end());
        const glm::ivec2 origin = size * placement.faces[static_cast<std::size_t>(face)];
        for (int row = 0; row < size; ++row)
            std::copy_n(&one.at(0, row), size, &picture.at(origin.x, origin.y + row));
    }
    return picture;
}

std::array<fs::path, 6> faceFiles(const std::string& patternOrFolder) {
    std::array<fs::path, 6> files;
    if (const auto hole = patternOrFolder.find("{}"); hole != std::string::npos) {
        std::string bestMissing;
        std::size_t bestFound = 0;
        for (const auto& names : kFaceNames) {
            std::size_t found = 0;
            std::string missing;
            for (std::size_t i = 0; i < 6; ++i) {
                files[i] = std::string(patternOrFolder).replace(hole, 2, names[i]);
                std::error_code error;
                if (fs::exists(files[i], error))
                    ++found;
                else if (missing.empty())
                    missing = files[i].string();
            }
            if (found == 6) return files;
            if (found > bestFound) {
                bestFound = found;
                bestMissing = missing;
            }
        }
        if (bestFound == 0)
            throw Error(fmt::format("{}: no such files; {{}} stands for {} or {} or {}",
                                    patternOrFolder, listOf(kFaceNames[0]), listOf(kFaceNames[1]),
                                    listOf(kFaceNames[2])));
        throw Error(fmt::format("{}: {} of six faces found; {} is missing", patternOrFolder,
                                bestFound, bestMissing));
    }

    std::vector<fs::path> pictures;
    std::error_code error;
    for (fs::directory_iterator entry(patternOrFolder, error), end; !error && entry != end;
         entry.increment(error))
        if (isPicture(entry->path())) pictures.push_back(entry->path());
    if (error) throw Error(fmt::format("{}: cannot be read: {}", patternOrFolder, error.message()));
    for (const auto& names : kFaceNames) {
        int found = 0;
        for (std::size_t i = 0; i < 6; ++i) {
            const auto called = [&](const fs::path& path) { return isCalled(path, names[i]); };
            const auto count = std::count_if(pictures.begin(), pictures.end(), called);
            if (count > 1)
                throw Error(fmt::format(
                    "{}: {} files are called {}; say which by a pattern, as sky_{{}}.png",
                    patternOrFolder, count, names[i]));
            if (count == 1) {
                files[i] = *std::find_if(pictures.begin(), pictures.end(), called);
                ++found;
            }
        }
        if (found == 6) return files;
    }
    throw Error(fmt::format(
        "{}: a folder without the six faces; expected files called {} or {} or {}", patternOrFolder,
        listOf(kFaceNames[0]), listOf(kFaceNames[1]), listOf(kFaceNames[2])));
}

CubeMap cubeFromFaces(std::span<const Image, 6> faces, std::span<const std::string, 6> names) {
    const int size = faces[0].width();
    for (std::size_t i = 0; i < 6; ++i) {
        if (faces[i].width() != faces[i].height())
            throw Error(fmt::format("{}: {} x {} pixels; a face of a cube map must be square",
                                    names[i], faces[i].width(), faces[i].height()));
        if (faces[i].width() != size)
            throw Error(fmt::format("{}: {} x {} pixels; all faces must have the {} x {} of {}",
                                    names[i], faces[i].width(), faces[i].height(), size, size,
                                    names[0]));
    }
    CubeMap cube(size);
    for (const CubeFace face : kCubeFaces) {
        const auto source = faces[static_cast<std::size_t>(face)].pixels();
        std::copy(source.begin(), source.end(), cube.texels(face).begin());
    }
    return cube;
}

}  // namespace tukor
