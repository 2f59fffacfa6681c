// What model files say of a surface, in the terms of glTF, and what is made of it here.
#pragma once
#include <algorithm>
#include <cmath>
#include <string>

#include <glm/glm.hpp>

#include "tukor/materials/material.h"
#include "tukor/scene/finish.h"
#include "tukor/scene/notes.h"

namespace tukor {

/// A finish with what lies behind it; other formats are translated into it.
struct Surface : Finish {
    std::string name;
    glm::vec3 attenuationColor{1.0f};  // left of white light after attenuationDistance
    float attenuationDistance = 0.0f;  // m; 0: nothing is absorbed
    float dispersion = 0.0f;           // 20 over Abbe's number
};

/// Roughness up to which a surface is taken for ideally smooth: below, the highlight is narrower
/// than most texels of an environment.
inline constexpr float kPolished = 0.05f;

/// Whether it is one of the ideal smooth surfaces of Material, to which no finish adds anything:
/// polished metal, or clear glass with an inside.
[[nodiscard]] bool isIdeal(const Surface& surface) noexcept;

/// The roughness of GGX whose highlight is as wide as Blinn's of that exponent. [Karis 2013]
[[nodiscard]] inline float roughnessFromExponent(float exponent) noexcept {
    return std::pow(2.0f / (std::max(exponent, 0.0f) + 2.0f), 0.25f);
}

/// TextureMap::imageFromUv of formats in which v runs up, for coordinates whose v the reader has
/// turned round: `scale` and `offset` are the format's.
[[nodiscard]] inline glm::mat3x2 imageFromUpwardUv(glm::vec2 scale, glm::vec2 offset) noexcept {
    return {glm::vec2(scale.x, 0.0f), glm::vec2(0.0f, scale.y),
            glm::vec2(offset.x, 1.0f - scale.y - offset.y)};
}

/// A factor that exporters leave black, or away, beside its texture: that counts alone.
template <typename Factor>
void countTextureAlone(Factor& factor) noexcept {
    if (factor == Factor(0.0f)) factor = Factor(1.0f);
}

/// Below this share of opacity what files say is taken for clear glass.
inline constexpr float kGlassBelow = 0.5f;

/// What hides only so much of what is behind it.
inline void setOpacity(Surface& surface, float opacity) noexcept {
    if (!(opacity < 1.0f)) return;
    surface.alpha = std::max(opacity, 0.0f);
    surface.alphaMode = AlphaMode::blend;
}

[[nodiscard]] bool hasTextures(const Surface& surface) noexcept;

/// An ideal surface: a metal whose reflectance at normal incidence is the base colour, or a
/// dielectric with that absorption. Else the nearest of these, with the finish.
[[nodiscard]] Material materialOf(const Surface& surface);

}  // namespace tukor
