#include "tukor/scene/gltf_textures.h"

#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/scene/picture_decoding.h"
#include "tukor/scene/sibling_file.h"

namespace tukor {

namespace {

Wrap wrapOf(const JsonItem& sampler, const char* member) {
    switch (const std::size_t code = sampler.countOr(member, 10497)) {
        case 10497:
            return Wrap::repeat;
        case 33071:
            return Wrap::clamp;
        case 33648:
            return Wrap::mirror;
        default:
            sampler.fail(fmt::format("{} {}; expected 10497, 33071 or 33648", member, code));
    }
}

#ifdef __EMSCRIPTEN__
std::map<std::size_t, Texels> givenImages;
#endif

/// The set of texture coordinates that it names; far ones are one that nothing has.
int uvSetOf(const JsonItem& item, int usual) {
    return static_cast<int>(
        std::min<std::size_t>(item.countOr("texCoord", static_cast<std::size_t>(usual)), 1000));
}

// Offset, then rotation, then scale; the rotation turns pictures counter-clockwise as v runs down.
void transform(const JsonItem& extension, TextureMap& map) {
    const auto offset = extension.numbers<2>("offset").value_or(std::array<double, 2>{0.0, 0.0});
    const auto scale = extension.numbers<2>("scale").value_or(std::array<double, 2>{1.0, 1.0});
    const double angle = extension.numberOr("rotation", 0.0);
    const double c = std::cos(angle), s = std::sin(angle);
    map.imageFromUv =
        glm::mat3x2(glm::vec2(c * scale[0], -s * scale[0]), glm::vec2(s * scale[1], c * scale[1]),
                    glm::vec2(offset[0], offset[1]));
    map.uvSet = uvSetOf(extension, map.uvSet);
}

}  // namespace

#ifdef __EMSCRIPTEN__
void giveGltfImage(std::size_t index, Texels texels) {
    givenImages[index] = std::move(texels);
}
#endif

TextureMap GltfTextures::mapOf(const JsonItem& textureInfo, std::string_view material) {
    TextureMap map;
    map.uvSet = uvSetOf(textureInfo, 0);
    if (const std::optional<JsonItem> extensions = textureInfo.find("extensions"))
        if (const std::optional<JsonItem> extension = extensions->find("KHR_texture_transform"))
            transform(*extension, map);
    if (map.uvSet < 0 || map.uvSet > 1) {
        notes_.add("textures on a third set of coordinates are not rendered", material);
        return {};
    }
    const JsonItem texture = document_.referred("textures", textureInfo, "index");
    if (const std::optional<JsonItem> index = texture.find("sampler")) {
        const JsonItem sampler = document_.item("samplers", index->count(), *index);
        map.wrapU = wrapOf(sampler, "wrapS");
        map.wrapV = wrapOf(sampler, "wrapT");
        map.smooth = sampler.countOr("magFilter", 9729) != 9728;
    }
    const std::optional<JsonItem> source = texture.find("source");
    if (!source) {
        notes_.add("textures in formats that are not read (only .png and .jpg are), left out",
                   material);
        return {};
    }
    std::shared_ptr<Texels>& texels = known_[source->count()];
    if (!texels) {
        texels = std::make_shared<Texels>();
        wanted_.emplace_back(source->count(), *source);
    }
    map.texels = texels;
    return map;
}

void GltfTextures::decode() {
#ifdef __EMSCRIPTEN__
    for (const auto& [index, user] : wanted_) {
        const auto given = givenImages.find(index);
        if (given == givenImages.end())
            notes_.add("textures that the browser cannot decode, left out",
                       fmt::format("image {}", index));
        else
            *known_[index] = std::move(given->second);
    }
    wanted_.clear();
    givenImages.clear();
#else
    std::vector<PendingPicture> pictures(wanted_.size());
    for (std::size_t i = 0; i < wanted_.size(); ++i) {
        PendingPicture& picture = pictures[i];
        const JsonItem image = document_.item("images", wanted_[i].first, wanted_[i].second);
        picture.texels = known_[wanted_[i].first];
        try {
            picture.name = image.textOr("name", "");
            if (const std::optional<JsonItem> uri = image.find("uri")) {
                if (picture.name.empty() && !uri->text().starts_with("data:"))
                    picture.name = printable(uri->text());
                const auto loaded = std::make_shared<GltfBytes>(document_.contents(*uri));
                picture.bytes = loaded->bytes();
                picture.owner = loaded;
            } else {
                picture.bytes = document_.view(image.at("bufferView").count(), image).bytes;
            }
            if (picture.name.empty()) picture.name = fmt::format("image {}", wanted_[i].first);
        } catch (const Error& error) {
            picture.trouble = error.what();
        }
    }
    wanted_.clear();
    decodePictures(pictures, document_.name(), notes_);
#endif
}

}  // namespace tukor
