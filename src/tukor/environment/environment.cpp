#include "tukor/environment/environment.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/environment/cube_mips.h"
#include "tukor/environment/equirect.h"
#include "tukor/environment/layout.h"
#include "tukor/environment/procedural.h"
#include "tukor/environment/repair.h"
#include "tukor/image/image_file.h"

namespace tukor {

namespace fs = std::filesystem;

namespace {

struct BuiltIn {
    std::string_view name;
    CubeMap (*make)(int faceSize);
};

constexpr std::array kBuiltIns = {
    BuiltIn{"studio", [](int faceSize) { return studioCube(faceSize); }},
    BuiltIn{"sky", [](int faceSize) { return skyCube(faceSize); }},
};
constexpr int kBuiltInFaceSize = 512;    // as a 1k panorama gets
constexpr int kLargestOwnChoice = 2048;  // 300 MB of texels; more has to be asked for

CubeMap atFaceSize(CubeMap cube, const std::optional<int>& faceSize) {
    if (!faceSize || *faceSize == cube.faceSize()) return cube;
    return resizedCube(cube, *faceSize);
}

Environment fromPicture(const std::string& path, const EnvironmentOptions& options) {
    Image picture = loadImage(path);
    const std::optional<Layout> layout = layoutOfShape(picture.width(), picture.height());
    if (!layout)
        throw Error(
            fmt::format("{}: {} x {} pixels; an equirectangular panorama must be exactly twice "
                        "as wide as high, a cube map a cross of 4 x 3 or 3 x 4 squares or a "
                        "strip of six",
                        path, picture.width(), picture.height()));
    std::vector<std::string> warnings = describeRepairs(repairRadiance(picture));
    if (*layout != Layout::equirect)
        return {path, atFaceSize(cubeFromLayout(picture, *layout), options.faceSize),
                std::move(warnings)};
    const int faceSize = options.faceSize.value_or(
        std::min(faceSizeForEquirect(picture.width()), kLargestOwnChoice));
    CubeMap cube = cubeFromEquirect(picture, faceSize);
    return {path, std::move(cube), std::move(warnings),
            std::make_shared<const Image>(std::move(picture))};
}

Environment fromSixFiles(const std::string& patternOrFolder, const EnvironmentOptions& options) {
    const std::array<fs::path, 6> files = faceFiles(patternOrFolder);
    std::array<Image, 6> faces;
    std::array<std::string, 6> names;
    RepairCount repairs;
    for (std::size_t i = 0; i < 6; ++i) {
        names[i] = files[i].string();
        faces[i] = loadImage(files[i]);
        const RepairCount count = repairRadiance(faces[i]);
        repairs.notFinite += count.notFinite;
        repairs.negative += count.negative;
    }
    return {patternOrFolder, atFaceSize(cubeFromFaces(faces, names), options.faceSize),
            describeRepairs(repairs)};
}

}  // namespace

Environment loadEnvironment(const std::string& nameOrPath, const EnvironmentOptions& options) {
    if (options.faceSize &&
        (*options.faceSize < kFaceSizeRange.least || *options.faceSize > kFaceSizeRange.most))
        throw Error(fmt::format("{}: a face size of {} texels; expected {} to {}", nameOrPath,
                                *options.faceSize, kFaceSizeRange.least, kFaceSizeRange.most));
    for (const BuiltIn& builtIn : kBuiltIns)
        if (nameOrPath == builtIn.name)
            return {nameOrPath, builtIn.make(options.faceSize.value_or(kBuiltInFaceSize)), {}};

    std::error_code error;
    const fs::path path(nameOrPath);
    const fs::file_status status = fs::status(path, error);
    if (fs::is_directory(status) || nameOrPath.find("{}") != std::string::npos)
        return fromSixFiles(nameOrPath, options);
    if (!fs::exists(status) && !path.has_extension() && !path.has_parent_path()) {
        std::vector<std::string_view> names;
        for (const BuiltIn& builtIn : kBuiltIns) names.push_back(builtIn.name);
        throw Error(fmt::format("{}: no such environment; built in are {}, anything else is a file",
                                nameOrPath, fmt::join(names, ", ")));
    }
    return fromPicture(nameOrPath, options);
}

}  // namespace tukor
