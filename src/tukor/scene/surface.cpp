#include "tukor/scene/surface.h"

#include <algorithm>
#include <cmath>

#include "tukor/materials/materials.h"

namespace tukor {

namespace {

// exp(-sigmaA distance) = colour; a colour of 0 would absorb infinitely: 1e-4 is black enough.
glm::vec3 absorption(glm::vec3 colour, float distance) noexcept {
    if (!(distance > 0.0f) || !std::isfinite(distance)) return glm::vec3(0.0f);
    const glm::vec3 clamped = glm::clamp(colour, glm::vec3(1e-4f), glm::vec3(1.0f));
    return glm::max(-glm::log(clamped) / std::max(distance, 1e-9f), glm::vec3(0.0f));
}

Material nearestIdeal(const Surface& surface) {
    const glm::vec3 colour = glm::clamp(surface.baseColor, glm::vec3(0.0f), glm::vec3(1.0f));
    if (surface.metallic >= 0.5f) return metalFromReflectance(colour);
    if (surface.transmission > 0.0f && surface.solid) {
        Material material =
            dielectricMaterial(std::clamp(surface.ior, 1.0f, 10.0f),
                               absorption(surface.attenuationColor, surface.attenuationDistance));
        material.dispersion = surface.dispersion;
        return material;
    }
    return mirrorMaterial(colour);
}

}  // namespace

bool hasTextures(const Surface& surface) noexcept {
    return std::any_of(surface.maps.begin(), surface.maps.end(),
                       [](const TextureMap& map) { return map.texels != nullptr; });
}

bool isIdeal(const Surface& surface) noexcept {
    const bool plain = surface.roughness <= kPolished && surface.alphaMode == AlphaMode::opaque &&
                       surface.emission == glm::vec3(0.0f) && !surface.unlit &&
                       surface.clearcoat == 0.0f && surface.sheenColor == glm::vec3(0.0f) &&
                       surface.iridescence == 0.0f && surface.specular == 1.0f &&
                       surface.specularColor == glm::vec3(1.0f) && !hasTextures(surface);
    const bool metal = surface.metallic == 1.0f;
    const bool glass = surface.metallic == 0.0f && surface.transmission == 1.0f && surface.solid &&
                       surface.baseColor == glm::vec3(1.0f);
    return plain && (metal || glass);
}

Material materialOf(const Surface& surface) {
    Material material = nearestIdeal(surface);
    if (!isIdeal(surface)) material.finish = std::make_shared<Finish>(surface);
    return material;
}

}  // namespace tukor
