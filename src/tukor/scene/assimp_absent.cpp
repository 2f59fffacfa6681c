// In place of assimp_file.cpp where Assimp is not: in the browser.
#ifdef __EMSCRIPTEN__
#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/scene/assimp_file.h"

namespace tukor {

Scene loadThroughAssimp(const std::filesystem::path& path, std::span<const std::byte>,
                        const ModelOptions&) {
    throw Error(fmt::format("{}: not a model of a format known here", path.string()));
}

bool assimpReads(const std::string&) {
    return false;
}

}  // namespace tukor
#endif
