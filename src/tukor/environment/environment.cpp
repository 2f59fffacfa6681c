#include "tukor/environment/environment.h"

#include <algorithm>

#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/environment/procedural.h"

namespace tukor {

namespace {

struct BuiltIn {
    std::string_view name;
    CubeMap (*make)(int faceSize);
};

constexpr BuiltIn kBuiltIns[] = {
    {"studio", [](int faceSize) { return studioCube(faceSize); }},
    {"sky", [](int faceSize) { return skyCube(faceSize); }},
};
constexpr int kBuiltInFaceSize = 512;  // as a 1k panorama gets

}  // namespace

Environment loadEnvironment(const std::string& nameOrPath, const EnvironmentOptions& options) {
    for (const BuiltIn& builtIn : kBuiltIns)
        if (nameOrPath == builtIn.name)
            return {nameOrPath, builtIn.make(options.faceSize.value_or(kBuiltInFaceSize)), {}};
    throw Error(fmt::format("{}: no such environment; built in are studio, sky", nameOrPath));
}

}  // namespace tukor
