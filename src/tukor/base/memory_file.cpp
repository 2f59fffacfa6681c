#include "tukor/base/memory_file.h"

#ifdef __EMSCRIPTEN__
#include <map>
#include <utility>

#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/base/file.h"

namespace tukor {

namespace {

std::map<std::string, std::vector<std::byte>>& files() {
    static std::map<std::string, std::vector<std::byte>> all;
    return all;
}

}  // namespace

void giveMemoryFile(std::string name, std::vector<std::byte> bytes) {
    files()[std::move(name)] = std::move(bytes);
}

void forgetMemoryFiles() {
    files().clear();
}

MappedFile::MappedFile(const std::filesystem::path& path, std::uint64_t) {
    const auto found = files().find(path.string());
    if (found == files().end()) throw Error(fmt::format("{}: no such file", path.string()));
    bytes_ = found->second;
}

MappedFile::~MappedFile() = default;

}  // namespace tukor
#endif
