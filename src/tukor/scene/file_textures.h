// The textures of models other than glTF: pictures beside the model or inside of it.
#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tukor/scene/notes.h"
#include "tukor/scene/picture_decoding.h"

namespace tukor {

/// Pictures are asked for while materials are read, and decoded together at the end: until then
/// they are empty.
class FileTextures {
public:
    using Picture = std::shared_ptr<const Texels>;  // null where there is none

    FileTextures(std::filesystem::path model, Notes& notes)
        : model_(std::move(model)), notes_(notes) {}

    /// The picture of that name below the model's folder; where exporters left a path of another
    /// machine, the file of that name beside the model. Where there is none, that is noted.
    [[nodiscard]] Picture file(std::string_view name);

    /// A PNG or JPEG inside of the model, which must live until decode(). `name` is for messages,
    /// and one picture's own.
    [[nodiscard]] Picture encoded(std::string_view name, std::span<const std::byte> bytes);

    // Of pictures that formats keep apart, as texel_channels.h puts them together. Null where none
    // is there.
    [[nodiscard]] Picture withOpacity(const Picture& colours, const Picture& opacity);
    [[nodiscard]] Picture metallicRoughness(const Picture& metallic, const Picture& roughness);
    [[nodiscard]] Picture normals(const Picture& relief, float strength);

    /// Decodes all. Throws Error where the pictures are too large together.
    void decode();

private:
    /// One that is made of others once these are decoded.
    Picture made(std::function<Texels()> make);

    std::filesystem::path model_;
    Notes& notes_;
    std::map<std::string, std::shared_ptr<Texels>> known_;
    std::vector<PendingPicture> pending_;
    std::vector<std::pair<std::shared_ptr<Texels>, std::function<Texels()>>> made_;
};

}  // namespace tukor
