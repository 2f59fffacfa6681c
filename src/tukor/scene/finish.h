// How a surface looks that is not ideally smooth: rough, diffuse, coated, textured, in the terms of
// glTF.
#pragma once
#include <array>
#include <memory>

#include <glm/glm.hpp>

#include "tukor/image/texels.h"

namespace tukor {

enum class Wrap { repeat, mirror, clamp };
enum class AlphaMode { opaque, mask, blend };

/// What a texture of a Finish multiplies, or says.
enum class TextureRole {
    baseColor,            // rgb sRGB, a alpha
    metallicRoughness,    // g roughness, b metallic
    normal,               // rgb, tangent space
    occlusion,            // r
    emission,             // rgb sRGB
    transmission,         // r
    specular,             // a
    specularColor,        // rgb sRGB
    clearcoat,            // r
    clearcoatRoughness,   // g
    clearcoatNormal,      // rgb, tangent space
    sheenColor,           // rgb sRGB
    sheenRoughness,       // a
    anisotropy,           // rg direction, b strength
    iridescence,          // r
    iridescenceThickness  // g
};
inline constexpr std::size_t kTextureRoles = 16;

/// Whether its colours are encoded as sRGB; the others are numbers.
[[nodiscard]] constexpr bool isSrgb(TextureRole role) noexcept {
    return role == TextureRole::baseColor || role == TextureRole::emission ||
           role == TextureRole::specularColor || role == TextureRole::sheenColor;
}

/// A picture on a surface.
struct TextureMap {
    std::shared_ptr<const Texels> texels;  // null: there is none, and its factor counts alone
    int uvSet = 0;                         // of Mesh::uvs
    glm::mat3x2 imageFromUv{1.0f};         // (0, 0) is the top left corner, v runs down
    Wrap wrapU = Wrap::repeat;
    Wrap wrapV = Wrap::repeat;
    bool smooth = true;  // false: the nearest texel
};

/// Whether there are finishes beside those of files, which alone ignore colours of vertices.
#ifdef __EMSCRIPTEN__
inline constexpr bool kFinishesByName = false;
#else
inline constexpr bool kFinishesByName = true;
#endif

/// glTF's metallic-roughness with its extensions. Factors multiply what the textures say.
struct Finish {
    glm::vec3 baseColor{1.0f};  // linear Rec. 709
    float alpha = 1.0f;
    AlphaMode alphaMode = AlphaMode::opaque;
    float alphaCutoff = 0.5f;
    float metallic = 1.0f;
    float roughness = 1.0f;  // perceptual: alpha of GGX is its square
    glm::vec3 emission{0.0f};
    float normalScale = 1.0f;
    float occlusionStrength = 1.0f;  // of light from all around, where nothing is traced
    bool doubleSided = false;
    bool catcher = false;  // ground: shows what is behind it but for shadows and light of things
    bool unlit = false;    // shows its base colour, whatever the light
    bool ignoresColors = false;  // of vertices, which multiply its base colour else

    float ior = 1.5f;               // of what is not metallic
    float specular = 1.0f;          // factor on its reflectance
    glm::vec3 specularColor{1.0f};  // likewise, at normal incidence
    float transmission = 0.0f;      // share of light that goes in and is not scattered
    bool solid = true;              // what lets light in bends it; false: a thin sheet
    float clearcoat = 0.0f;         // layer of index 1.5 over everything
    float clearcoatRoughness = 0.0f;
    float clearcoatNormalScale = 1.0f;
    glm::vec3 sheenColor{0.0f};  // of fibres over everything but the coat
    float sheenRoughness = 0.0f;
    float anisotropy = 0.0f;          // stretches highlights along the tangent, turned by:
    float anisotropyRotation = 0.0f;  // radians, counter-clockwise
    float iridescence = 0.0f;         // share of a thin film over the base
    float iridescenceIor = 1.3f;
    float iridescenceThinnest = 100.0f;  // nm, where its texture is 0
    float iridescenceThickest = 400.0f;  // nm, where it is 1 or there is none

    std::array<TextureMap, kTextureRoles> maps;

    [[nodiscard]] const TextureMap& map(TextureRole role) const noexcept {
        return maps[static_cast<std::size_t>(role)];
    }
    [[nodiscard]] bool has(TextureRole role) const noexcept {
        const Texels* const texels = map(role).texels.get();
        return texels != nullptr && texels->width > 0;
    }
};

}  // namespace tukor
