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

}  // namespace

Material materialOf(const Surface& surface, Notes& notes) {
    const glm::vec3 colour = glm::clamp(surface.baseColor, glm::vec3(0.0f), glm::vec3(1.0f));
    if (surface.roughness > 0.05f)  // below, the highlight is narrower than most texels of a map
        notes.add("roughness is not rendered; these look polished", surface.name);
    if (surface.metallic >= 0.5f) {
        if (surface.metallic < 1.0f)
            notes.add("partly metallic materials are rendered as metals", surface.name);
        return metalFromReflectance(colour);
    }
    if (surface.metallic > 0.0f)
        notes.add("partly metallic materials are rendered as not metallic", surface.name);
    if (surface.transmission >= 0.5f) {
        if (surface.transmission < 1.0f)
            notes.add("partly transmissive materials are rendered as clear", surface.name);
        if (colour != glm::vec3(1.0f))
            notes.add(
                "the tint of transmitted light at the surface is not rendered; give the "
                "volume an attenuation colour",
                surface.name);
        return dielectricMaterial(
            std::clamp(surface.ior, 1.0f, 10.0f),
            absorption(surface.attenuationColor, surface.attenuationDistance));
    }
    notes.add("diffuse surfaces are not rendered; these look like mirrors of their base colour",
              surface.name);
    return mirrorMaterial(colour);
}

}  // namespace tukor
