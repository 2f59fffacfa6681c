#include "tukor/scene/mtl_file.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "tukor/scene/text_scanner.h"

namespace tukor {

namespace {

// What follows the name of a texture: its options, and the file.
struct Picture {
    std::string file;  // empty: there is none
    glm::vec2 scale{1.0f}, offset{0.0f};
    bool clamped = false;
    float strength = 1.0f;  // of a relief
};

// What a library says of one material.
struct Entry {
    glm::vec3 diffuse{0.8f};
    glm::vec3 specular{0.0f};
    glm::vec3 emission{0.0f};
    float opacity = 1.0f;
    float ior = 1.5f;
    float clearcoat = 0.0f, clearcoatRoughness = 0.0f, sheen = 0.0f;
    std::optional<float> metallic, roughness, exponent;
    int model = 2;
    Picture colour, light, opacityMap, metallicMap, roughnessMap, normals, relief;
};

void readNumber(TextScanner& scanner, float& value) {
    if (const std::optional<float> number = floatOf(scanner.word());
        number && std::isfinite(*number))
        value = *number;
}

void readNumber(TextScanner& scanner, std::optional<float>& value) {
    float number = value.value_or(0.0f);
    readNumber(scanner, number);
    value = number;
}

void readColour(TextScanner& scanner, glm::vec3& value) {
    const std::optional<float> r = floatOf(scanner.word()), g = floatOf(scanner.word()),
                               b = floatOf(scanner.word());
    if (r && std::isfinite(*r)) value = glm::vec3(*r, g.value_or(*r), b.value_or(*r));
}

// One to three numbers, of which the first two count.
void readPair(TextScanner& scanner, glm::vec2& value) {
    for (int i = 0; i < 3; ++i) {
        TextScanner ahead = scanner;
        const std::optional<float> number = floatOf(ahead.word());
        if (!number) return;
        scanner = ahead;
        if (i < 2 && std::isfinite(*number)) value[i] = *number;
    }
}

Picture readPicture(TextScanner& scanner) {
    Picture picture;
    for (TextScanner ahead = scanner;; ahead = scanner) {
        const std::string_view option = ahead.word();
        if (option == "-s" || option == "-o" || option == "-t") {
            glm::vec2 unused;
            readPair(ahead, option == "-s"   ? picture.scale
                            : option == "-o" ? picture.offset
                                             : unused);
        } else if (option == "-bm") {
            readNumber(ahead, picture.strength);
        } else if (option == "-clamp") {
            picture.clamped = ahead.word() == "on";
        } else if (option == "-mm") {
            (void)ahead.word();
            (void)ahead.word();
        } else if (option == "-blendu" || option == "-blendv" || option == "-cc" ||
                   option == "-imfchan" || option == "-texres" || option == "-boost" ||
                   option == "-type") {
            (void)ahead.word();
        } else {
            break;
        }
        scanner = ahead;
    }
    picture.file = scanner.restOfLine();
    return picture;
}

TextureMap mapOf(const Picture& picture, std::shared_ptr<const Texels> texels) {
    TextureMap map;
    map.texels = std::move(texels);
    map.imageFromUv = imageFromUpwardUv(picture.scale, picture.offset);
    if (picture.clamped) map.wrapU = map.wrapV = Wrap::clamp;
    return map;
}

void addTextures(const Entry& entry, Surface& surface, FileTextures& textures) {
    const auto read = [&](const Picture& picture) {
        return picture.file.empty() ? nullptr : textures.file(picture.file);
    };
    const auto give = [&](TextureRole role, const Picture& picture, FileTextures::Picture texels) {
        if (texels)
            surface.maps[static_cast<std::size_t>(role)] = mapOf(picture, std::move(texels));
    };
    const FileTextures::Picture colour = read(entry.colour), opacity = read(entry.opacityMap);
    if (colour) countTextureAlone(surface.baseColor);
    if (opacity) surface.alphaMode = AlphaMode::blend;
    give(TextureRole::baseColor, colour ? entry.colour : entry.opacityMap,
         textures.withOpacity(colour, opacity));

    const FileTextures::Picture light = read(entry.light);
    if (light) countTextureAlone(surface.emission);
    give(TextureRole::emission, entry.light, light);

    const FileTextures::Picture metallic = read(entry.metallicMap),
                                roughness = read(entry.roughnessMap);
    if (metallic && !entry.metallic) surface.metallic = 1.0f;
    if (roughness && !entry.roughness) surface.roughness = 1.0f;
    give(TextureRole::metallicRoughness, metallic ? entry.metallicMap : entry.roughnessMap,
         textures.metallicRoughness(metallic, roughness));

    if (const FileTextures::Picture normals = read(entry.normals)) {
        give(TextureRole::normal, entry.normals, normals);
        surface.normalScale = entry.normals.strength;
    } else {
        give(TextureRole::normal, entry.relief,
             textures.normals(read(entry.relief), entry.relief.strength));
    }
}

Surface surfaceOf(const std::string& name, const Entry& entry, FileTextures& textures) {
    Surface surface;
    surface.name = name;
    const bool hasSpecular = entry.specular != glm::vec3(0.0f);
    const bool isMirror = (entry.model == 3 || entry.model == 5) && hasSpecular;
    surface.metallic = entry.metallic.value_or(isMirror ? 1.0f : 0.0f);
    // Some exporters write a grey highlight, and the metal's colour as the diffuse one.
    const auto isGrey = [](glm::vec3 c) { return c.x == c.y && c.y == c.z; };
    const bool bySpecular =
        isMirror && !entry.metallic && (!isGrey(entry.specular) || isGrey(entry.diffuse));
    surface.baseColor = bySpecular ? entry.specular : entry.diffuse;
    surface.roughness =
        entry.roughness.value_or(roughnessFromExponent(entry.exponent.value_or(0.0f)));
    // Some exporters write the illumination of glass for everything.
    const bool likeGlass =
        entry.model == 4 || entry.model == 6 || entry.model == 7 || entry.model == 9;
    const bool clear = entry.opacity < kGlassBelow || (likeGlass && entry.colour.file.empty());
    if (clear && surface.metallic < 0.5f) {
        surface.transmission = 1.0f;
        surface.metallic = 0.0f;
        surface.roughness = entry.roughness.value_or(0.0f);
        surface.baseColor = glm::vec3(1.0f);
        surface.ior = entry.ior > 1.0f ? entry.ior : 1.5f;  // 1: the exporter did not know
        return surface;
    }
    setOpacity(surface, entry.opacity);
    surface.emission = glm::max(entry.emission, 0.0f);
    surface.clearcoat = std::clamp(entry.clearcoat, 0.0f, 1.0f);
    surface.clearcoatRoughness = std::clamp(entry.clearcoatRoughness, 0.0f, 1.0f);
    surface.sheenColor = glm::vec3(std::clamp(entry.sheen, 0.0f, 1.0f));
    addTextures(entry, surface, textures);
    return surface;
}

}  // namespace

std::map<std::string, Surface> readMtl(std::span<const std::byte> bytes, FileTextures& textures,
                                       Notes& notes) {
    std::map<std::string, Entry> entries;
    Entry* entry = nullptr;
    std::string name;
    for (TextScanner scanner(bytes); !scanner.atEnd(); scanner.skipLine()) {
        const std::string_view key = scanner.word();
        if (key == "newmtl") {
            name = scanner.restOfLine();
            entry = &entries[name];
        }
        if (entry == nullptr) continue;
        if (key == "Kd") readColour(scanner, entry->diffuse);
        if (key == "Ks") readColour(scanner, entry->specular);
        if (key == "Ke") readColour(scanner, entry->emission);
        if (key == "d") readNumber(scanner, entry->opacity);
        if (key == "Tr") {
            float transparency = 0.0f;
            readNumber(scanner, transparency);
            entry->opacity = 1.0f - transparency;
        }
        if (key == "Ni") readNumber(scanner, entry->ior);
        if (key == "Ns") readNumber(scanner, entry->exponent);
        if (key == "Pm") readNumber(scanner, entry->metallic);
        if (key == "Pr") readNumber(scanner, entry->roughness);
        if (key == "Pc") readNumber(scanner, entry->clearcoat);
        if (key == "Pcr") readNumber(scanner, entry->clearcoatRoughness);
        if (key == "Ps") readNumber(scanner, entry->sheen);
        if (key == "illum") entry->model = static_cast<int>(integerOf(scanner.word()).value_or(2));
        if (key == "map_Kd") entry->colour = readPicture(scanner);
        if (key == "map_Ke") entry->light = readPicture(scanner);
        if (key == "map_d") entry->opacityMap = readPicture(scanner);
        if (key == "map_Pm") entry->metallicMap = readPicture(scanner);
        if (key == "map_Pr") entry->roughnessMap = readPicture(scanner);
        if (key == "norm") entry->normals = readPicture(scanner);
        if (key == "bump" || key == "map_bump" || key == "map_Bump")
            entry->relief = readPicture(scanner);
        if (key == "map_Ks" || key == "map_Ns" || key == "map_Ps" || key == "refl" ||
            key == "disp" || key == "decal")
            notes.add("not rendered: " + std::string(key), name);
    }
    std::map<std::string, Surface> surfaces;
    for (const auto& [title, one] : entries)
        surfaces.emplace(title, surfaceOf(title, one, textures));
    return surfaces;
}

}  // namespace tukor
