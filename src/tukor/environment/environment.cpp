#include "tukor/environment/environment.h"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/environment/cube_mips.h"
#include "tukor/environment/equirect.h"
#include "tukor/environment/layout.h"
#include "tukor/environment/procedural.h"
#include "tukor/environment/repair.h"

namespace tukor {

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

}  // namespace

std::vector<std::string_view> builtInEnvironmentNames() {
    std::vector<std::string_view> names;
    names.reserve(std::size(kBuiltIns));
    for (const BuiltIn& builtIn : kBuiltIns) names.push_back(builtIn.name);
    return names;
}

std::optional<Environment> builtInEnvironment(std::string_view name,
                                              const EnvironmentOptions& options) {
    for (const BuiltIn& builtIn : kBuiltIns)
        if (name == builtIn.name)
            return Environment{
                std::string(name), builtIn.make(options.faceSize.value_or(kBuiltInFaceSize)), {}};
    return std::nullopt;
}

Environment environmentFromPicture(const std::string& name, Image picture,
                                   const EnvironmentOptions& options) {
    const std::optional<Layout> layout = layoutOfShape(picture.width(), picture.height());
    if (!layout)
        throw Error(
            fmt::format("{}: {} x {} pixels; an equirectangular panorama must be exactly twice "
                        "as wide as high, a cube map a cross of 4 x 3 or 3 x 4 squares or a "
                        "strip of six",
                        name, picture.width(), picture.height()));
    std::vector<std::string> warnings = repairPictures(name, std::span(&picture, 1));
    if (*layout != Layout::equirect) {
        CubeMap cube = cubeFromLayout(picture, *layout);
        if (options.faceSize && *options.faceSize != cube.faceSize())
            cube = resizedCube(cube, *options.faceSize);
        return {name, std::move(cube), std::move(warnings)};
    }
    const int faceSize = options.faceSize.value_or(
        std::min(faceSizeForEquirect(picture.width()), kLargestOwnChoice));
    CubeMap cube = options.faceSize || options.cubeBesidePanorama
                       ? cubeFromEquirect(picture, faceSize)
                       : CubeMap(1);
    return {name, std::move(cube), std::move(warnings),
            std::make_shared<const Image>(std::move(picture))};
}

}  // namespace tukor
