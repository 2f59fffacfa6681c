// Environments from files; what a page loads in a browser comes by environmentFromPicture alone.
#include <array>
#include <filesystem>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/environment/cube_mips.h"
#include "tukor/environment/environment.h"
#include "tukor/environment/layout.h"
#include "tukor/environment/repair.h"
#include "tukor/environment/texture_chain.h"
#include "tukor/image/image_file.h"

namespace tukor {

namespace fs = std::filesystem;

namespace {

Environment fromSixFiles(const std::string& patternOrFolder, const EnvironmentOptions& options) {
    const std::array<fs::path, 6> files = faceFiles(patternOrFolder);
    std::array<Image, 6> faces;
    std::array<std::string, 6> names;
    for (std::size_t i = 0; i < 6; ++i) {
        names[i] = files[i].string();
        faces[i] = loadImage(files[i]);
    }
    std::vector<std::string> warnings = repairPictures(patternOrFolder, faces);
    CubeMap cube = cubeFromFaces(faces, names);
    if (options.faceSize && *options.faceSize != cube.faceSize())
        cube = resizedCube(cube, *options.faceSize);
    return {patternOrFolder, std::move(cube), std::move(warnings)};
}

}  // namespace

Environment loadEnvironment(const std::string& nameOrPath, const EnvironmentOptions& options) {
    if (options.faceSize &&
        (*options.faceSize < kFaceSizeRange.least || *options.faceSize > kFaceSizeRange.most))
        throw Error(fmt::format("{}: a face size of {} texels; expected {} to {}", nameOrPath,
                                *options.faceSize, kFaceSizeRange.least, kFaceSizeRange.most));
    if (std::optional<Environment> builtIn = builtInEnvironment(nameOrPath, options))
        return std::move(*builtIn);

    std::error_code error;
    const fs::path path(nameOrPath);
    const fs::file_status status = fs::status(path, error);
    if (fs::is_directory(status) || nameOrPath.find("{}") != std::string::npos)
        return fromSixFiles(nameOrPath, options);
    if (!fs::exists(status) && !path.has_extension() && !path.has_parent_path())
        throw Error(fmt::format("{}: no such environment; built in are {}, anything else is a file",
                                nameOrPath, fmt::join(builtInEnvironmentNames(), ", ")));
    if (std::optional<TextureFile> texture = loadIfTexture(path); texture && texture->faces == 6) {
        std::vector<std::string> warnings = repairFaces(nameOrPath, *texture);
        CubeMap cube = cubeFromTexture(*texture);
        if (options.faceSize && *options.faceSize != cube.faceSize())
            cube = resizedCube(cube, *options.faceSize);
        return {nameOrPath, std::move(cube), std::move(warnings)};
    }
    return environmentFromPicture(nameOrPath, loadPicture(path), options);
}

}  // namespace tukor
