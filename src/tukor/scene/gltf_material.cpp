#include "tukor/scene/gltf_material.h"

#include <algorithm>
#include <array>
#include <optional>

#include <fmt/format.h>

#include "tukor/scene/sibling_file.h"

namespace tukor {

namespace {

/// One object of JSON and the surface that it describes.
class Reader {
public:
    Reader(const JsonItem& item, Surface& surface, GltfTextures& textures)
        : item_(item), surface_(surface), textures_(textures) {}

    Reader& number(const char* name, float& value) {
        value = static_cast<float>(item_.numberOr(name, static_cast<double>(value)));
        return *this;
    }
    /// A share: clamped to [0, 1].
    Reader& share(const char* name, float& value) {
        number(name, value);
        value = std::clamp(value, 0.0f, 1.0f);
        return *this;
    }
    Reader& colour(const char* name, glm::vec3& value) {
        if (const std::optional<std::array<double, 3>> c = item_.numbers<3>(name))
            value = glm::max(glm::vec3((*c)[0], (*c)[1], (*c)[2]), glm::vec3(0.0f));
        return *this;
    }
    /// `scale` is read from the texture's own member of that name.
    Reader& texture(const char* name, TextureRole role, const char* scale = nullptr,
                    float* factor = nullptr) {
        const std::optional<JsonItem> info = item_.find(name);
        if (!info) return *this;
        surface_.maps[static_cast<std::size_t>(role)] = textures_.mapOf(*info, surface_.name);
        if (scale) *factor = static_cast<float>(info->numberOr(scale, 1.0));
        return *this;
    }

private:
    const JsonItem& item_;
    Surface& surface_;
    GltfTextures& textures_;
};

/// False where the extension is not known.
bool readExtension(const std::string& name, const JsonItem& item, Surface& s,
                   GltfTextures& textures) {
    Reader reader(item, s, textures);
    if (name == "KHR_materials_transmission") {
        reader.share("transmissionFactor", s.transmission)
            .texture("transmissionTexture", TextureRole::transmission);
    } else if (name == "KHR_materials_ior") {
        reader.number("ior", s.ior);
        if (s.ior != 0.0f) s.ior = std::clamp(s.ior, 1.0f, 10.0f);  // 0: reflects everything
    } else if (name == "KHR_materials_volume") {
        s.solid = true;
        reader.colour("attenuationColor", s.attenuationColor)
            .number("attenuationDistance", s.attenuationDistance);
    } else if (name == "KHR_materials_specular") {
        reader.share("specularFactor", s.specular)
            .colour("specularColorFactor", s.specularColor)
            .texture("specularTexture", TextureRole::specular)
            .texture("specularColorTexture", TextureRole::specularColor);
    } else if (name == "KHR_materials_clearcoat") {
        reader.share("clearcoatFactor", s.clearcoat)
            .share("clearcoatRoughnessFactor", s.clearcoatRoughness)
            .texture("clearcoatTexture", TextureRole::clearcoat)
            .texture("clearcoatRoughnessTexture", TextureRole::clearcoatRoughness)
            .texture("clearcoatNormalTexture", TextureRole::clearcoatNormal, "scale",
                     &s.clearcoatNormalScale);
    } else if (name == "KHR_materials_sheen") {
        reader.colour("sheenColorFactor", s.sheenColor)
            .share("sheenRoughnessFactor", s.sheenRoughness)
            .texture("sheenColorTexture", TextureRole::sheenColor)
            .texture("sheenRoughnessTexture", TextureRole::sheenRoughness);
    } else if (name == "KHR_materials_anisotropy") {
        reader.share("anisotropyStrength", s.anisotropy)
            .number("anisotropyRotation", s.anisotropyRotation)
            .texture("anisotropyTexture", TextureRole::anisotropy);
    } else if (name == "KHR_materials_iridescence") {
        reader.share("iridescenceFactor", s.iridescence)
            .number("iridescenceIor", s.iridescenceIor)
            .number("iridescenceThicknessMinimum", s.iridescenceThinnest)
            .number("iridescenceThicknessMaximum", s.iridescenceThickest)
            .texture("iridescenceTexture", TextureRole::iridescence)
            .texture("iridescenceThicknessTexture", TextureRole::iridescenceThickness);
        s.iridescenceIor = std::clamp(s.iridescenceIor, 1.0f, 10.0f);
    } else if (name == "KHR_materials_emissive_strength") {
        s.emission *= static_cast<float>(std::max(item.numberOr("emissiveStrength", 1.0), 0.0));
    } else if (name == "KHR_materials_dispersion") {
        reader.number("dispersion", s.dispersion);
        s.dispersion = std::clamp(s.dispersion, 0.0f, 100.0f);
    } else if (name == "KHR_materials_unlit") {
        s.unlit = true;
    } else {
        return false;
    }
    return true;
}

void readAlpha(const JsonItem& material, Surface& s) {
    const std::string mode = material.textOr("alphaMode", "OPAQUE");
    if (mode == "MASK")
        s.alphaMode = AlphaMode::mask;
    else if (mode == "BLEND")
        s.alphaMode = AlphaMode::blend;
    else if (mode != "OPAQUE")
        material.fail(
            fmt::format("alphaMode '{}'; expected OPAQUE, MASK or BLEND", printable(mode)));
    s.alphaCutoff = static_cast<float>(material.numberOr("alphaCutoff", 0.5));
    s.doubleSided = material.truthOr("doubleSided", false);
}

}  // namespace

Surface readGltfMaterial(const JsonItem& material, std::string_view fallbackName,
                         GltfTextures& textures, Notes& notes) {
    Surface surface;
    surface.name = material.textOr("name", fallbackName);
    surface.solid = false;  // without a volume
    if (const std::optional<JsonItem> pbr = material.find("pbrMetallicRoughness")) {
        if (const std::optional<std::array<double, 4>> c = pbr->numbers<4>("baseColorFactor")) {
            surface.baseColor =
                glm::clamp(glm::vec3((*c)[0], (*c)[1], (*c)[2]), glm::vec3(0.0f), glm::vec3(1.0f));
            surface.alpha = static_cast<float>(std::clamp((*c)[3], 0.0, 1.0));
        }
        Reader(*pbr, surface, textures)
            .share("metallicFactor", surface.metallic)
            .share("roughnessFactor", surface.roughness)
            .texture("baseColorTexture", TextureRole::baseColor)
            .texture("metallicRoughnessTexture", TextureRole::metallicRoughness);
    }
    Reader(material, surface, textures)
        .colour("emissiveFactor", surface.emission)
        .texture("normalTexture", TextureRole::normal, "scale", &surface.normalScale)
        .texture("occlusionTexture", TextureRole::occlusion, "strength", &surface.occlusionStrength)
        .texture("emissiveTexture", TextureRole::emission);
    readAlpha(material, surface);
    if (const std::optional<JsonItem> extensions = material.find("extensions"))
        for (const std::string& name : extensions->memberNames())
            if (!readExtension(name, extensions->at(name.c_str()), surface, textures))
                notes.add("not rendered: " + printable(name), surface.name);
    return surface;
}

}  // namespace tukor
