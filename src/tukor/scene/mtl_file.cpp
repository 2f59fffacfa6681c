#include "tukor/scene/mtl_file.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include "tukor/scene/text_scanner.h"

namespace tukor {

namespace {

// What a library says of one material.
struct Entry {
    glm::vec3 diffuse{0.8f};
    glm::vec3 specular{0.0f};
    float opacity = 1.0f;
    float ior = 1.5f;
    std::optional<float> metallic, roughness, exponent;
    int model = 2;
    bool textured = false;
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

Surface surfaceOf(const std::string& name, const Entry& entry, Notes& notes) {
    Surface surface;
    surface.name = name;
    const bool hasSpecular = entry.specular != glm::vec3(0.0f);
    const bool isMirror = (entry.model == 3 || entry.model == 5) && hasSpecular;
    surface.metallic = entry.metallic.value_or(isMirror ? 1.0f : 0.0f);
    surface.baseColor = isMirror && !entry.metallic ? entry.specular : entry.diffuse;
    // Blinn's exponent as the roughness whose highlight is as wide. [Karis 2013]
    const float fromExponent =
        std::pow(2.0f / (std::max(entry.exponent.value_or(0.0f), 0.0f) + 2.0f), 0.25f);
    surface.roughness = entry.roughness.value_or(fromExponent);
    const bool clear = entry.opacity < 0.5f || entry.model == 4 || entry.model == 6 ||
                       entry.model == 7 || entry.model == 9;
    if (clear && surface.metallic < 0.5f) {
        surface.transmission = 1.0f;
        surface.metallic = 0.0f;
        surface.roughness = entry.roughness.value_or(0.0f);
        surface.baseColor = glm::vec3(1.0f);
        surface.ior = entry.ior > 1.0f ? entry.ior : 1.5f;  // 1: the exporter did not know
    }
    if (entry.textured) notes.add("textures are not rendered", name);
    return surface;
}

}  // namespace

std::map<std::string, Surface> readMtl(std::span<const std::byte> bytes, Notes& notes) {
    std::map<std::string, Entry> entries;
    Entry* entry = nullptr;
    for (TextScanner scanner(bytes); !scanner.atEnd(); scanner.skipLine()) {
        const std::string_view key = scanner.word();
        if (key == "newmtl") entry = &entries[std::string(scanner.restOfLine())];
        if (entry == nullptr) continue;
        if (key == "Kd") readColour(scanner, entry->diffuse);
        if (key == "Ks") readColour(scanner, entry->specular);
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
        if (key == "illum") entry->model = static_cast<int>(integerOf(scanner.word()).value_or(2));
        if (key.starts_with("map_") || key == "bump" || key == "norm") entry->textured = true;
    }
    std::map<std::string, Surface> surfaces;
    for (const auto& [name, one] : entries) surfaces.emplace(name, surfaceOf(name, one, notes));
    return surfaces;
}

}  // namespace tukor
