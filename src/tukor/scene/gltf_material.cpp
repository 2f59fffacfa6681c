#include "tukor/scene/gltf_material.h"

#include <array>
#include <optional>

#include "tukor/scene/sibling_file.h"

namespace tukor {

namespace {

glm::vec3 colourOr(const JsonItem& item, const char* name, glm::vec3 absent) {
    const std::optional<std::array<double, 3>> c = item.numbers<3>(name);
    return c ? glm::vec3((*c)[0], (*c)[1], (*c)[2]) : absent;
}

void readExtensions(const JsonItem& extensions, Surface& surface, Notes& notes) {
    for (const std::string& name : extensions.memberNames()) {
        const JsonItem extension = extensions.at(name.c_str());
        if (name == "KHR_materials_transmission") {
            surface.transmission =
                static_cast<float>(extension.numberOr("transmissionFactor", 0.0));
            if (extension.find("transmissionTexture"))
                notes.add("textures are not rendered", surface.name);
        } else if (name == "KHR_materials_ior") {
            surface.ior = static_cast<float>(extension.numberOr("ior", 1.5));
        } else if (name == "KHR_materials_volume") {
            surface.attenuationColor = colourOr(extension, "attenuationColor", glm::vec3(1.0f));
            surface.attenuationDistance =
                static_cast<float>(extension.numberOr("attenuationDistance", 0.0));
            if (extension.find("thicknessTexture"))
                notes.add("textures are not rendered", surface.name);
        } else {
            notes.add("not rendered: " + printable(name), surface.name);
        }
    }
}

void noteRest(const JsonItem& material, const Surface& surface, Notes& notes) {
    for (const char* const texture : {"normalTexture", "occlusionTexture", "emissiveTexture"})
        if (material.find(texture)) notes.add("textures are not rendered", surface.name);
    if (colourOr(material, "emissiveFactor", glm::vec3(0.0f)) != glm::vec3(0.0f))
        notes.add("emitted light is not rendered", surface.name);
    if (material.textOr("alphaMode", "OPAQUE") != "OPAQUE")
        notes.add("alpha is not rendered; these are opaque", surface.name);
}

}  // namespace

Surface readGltfMaterial(const JsonItem& material, std::string_view fallbackName, Notes& notes) {
    Surface surface;
    surface.name = material.textOr("name", fallbackName);
    if (const std::optional<JsonItem> pbr = material.find("pbrMetallicRoughness")) {
        if (const std::optional<std::array<double, 4>> c = pbr->numbers<4>("baseColorFactor"))
            surface.baseColor = glm::vec3((*c)[0], (*c)[1], (*c)[2]);
        surface.metallic = static_cast<float>(pbr->numberOr("metallicFactor", 1.0));
        surface.roughness = static_cast<float>(pbr->numberOr("roughnessFactor", 1.0));
        if (pbr->find("baseColorTexture") || pbr->find("metallicRoughnessTexture"))
            notes.add("textures are not rendered", surface.name);
    }
    const std::optional<JsonItem> extensions = material.find("extensions");
    if (extensions) readExtensions(*extensions, surface, notes);
    if (surface.transmission > 0.0f && !(extensions && extensions->find("KHR_materials_volume")))
        notes.add("thin walls are rendered as solid glass", surface.name);
    noteRest(material, surface, notes);
    return surface;
}

}  // namespace tukor
