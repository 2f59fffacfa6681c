#include "tukor/scene/file_textures.h"

#include <algorithm>
#include <system_error>

#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/base/file.h"
#include "tukor/scene/sibling_file.h"
#include "tukor/scene/texel_channels.h"

namespace tukor {

namespace {

/// File names are no URIs: a percent sign is one.
std::string asUri(std::string_view name) {
    std::string uri;
    for (const char c : name) {
        if (c == '%')
            uri += "%25";
        else
            uri += c;
    }
    return uri;
}

FileTextures::Picture orEmpty(const FileTextures::Picture& picture) {
    return picture ? picture : std::make_shared<const Texels>();
}

}  // namespace

FileTextures::Picture FileTextures::file(std::string_view name) {
    std::string path(name);
    std::replace(path.begin(), path.end(), '\\', '/');
    const std::string last = path.substr(path.rfind('/') + 1);
    std::string trouble = fmt::format("{}: no such file", printable(last));
    for (const std::string& candidate : {path, last}) {
        try {
            const std::filesystem::path target = siblingPath(model_, asUri(candidate));
            std::shared_ptr<Texels>& texels = known_[target.string()];
            if (texels) return texels;
            std::error_code ignored;
            if (!std::filesystem::is_regular_file(target, ignored)) continue;
            const auto file = std::make_shared<MappedFile>(target);
            texels = std::make_shared<Texels>();
            pending_.push_back({file, file->bytes(), printable(last), "", texels});
            return texels;
        } catch (const Error& error) {
            if (candidate == last) trouble = error.what();
        }
    }
    notes_.add("textures that cannot be read, left out", trouble);
    return nullptr;
}

FileTextures::Picture FileTextures::encoded(std::string_view name,
                                            std::span<const std::byte> bytes) {
    std::shared_ptr<Texels>& texels = known_[fmt::format("*{}", name)];
    if (!texels) {
        texels = std::make_shared<Texels>();
        pending_.push_back({nullptr, bytes, printable(name), "", texels});
    }
    return texels;
}

FileTextures::Picture FileTextures::withOpacity(const Picture& colours, const Picture& opacity) {
    if (!opacity) return colours;
    return made([a = orEmpty(colours), b = opacity] { return tukor::withOpacity(*a, *b); });
}

FileTextures::Picture FileTextures::metallicRoughness(const Picture& metallic,
                                                      const Picture& roughness) {
    if (!metallic && !roughness) return nullptr;
    return made(
        [a = orEmpty(metallic), b = orEmpty(roughness)] { return metallicRoughnessOf(*a, *b); });
}

FileTextures::Picture FileTextures::normals(const Picture& relief, float strength) {
    if (!relief) return nullptr;
    return made([relief, strength] { return normalsOf(*relief, strength); });
}

FileTextures::Picture FileTextures::made(std::function<Texels()> make) {
    return made_.emplace_back(std::make_shared<Texels>(), std::move(make)).first;
}

void FileTextures::decode() {
    decodePictures(pending_, model_.string(), notes_);
    pending_.clear();
    for (const auto& [texels, make] : made_) *texels = make();
    made_.clear();
}

}  // namespace tukor
