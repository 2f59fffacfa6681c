// Named materials with their sources, and materials from figures or reflectances.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tukor/materials/material.h"

namespace tukor {

// Where dielectrics overlap the higher priority displaces the lower, so that a liquid may be
// modelled a little too large for its vessel, ice may float in water, and a bubble is a surface of
// air inside glass.
inline constexpr int kLiquidPriority = 10;
inline constexpr int kIcePriority = 20;
inline constexpr int kSolidPriority = 30;
inline constexpr int kBubblePriority = 40;

/// Figures of a smooth material; those that its kind has.
struct MaterialFigures {
    MaterialKind kind;
    glm::vec3 first;         // tint of a mirror, eta of the others
    glm::vec3 second{0.0f};  // k of a metal, sigmaA of a dielectric
    int priority = 0;
    float colourSize = 0.0f;
};

/// One row of the table that `tukor materials` prints.
struct NamedMaterial {
    std::string_view name;
    std::string_view description;
    MaterialFigures figures;
    std::string_view wavelengths;  // in nm, for R, G, B or for all three; empty: not measured
    std::string_view source;       // as in docs/references.md
    float abbe = 0.0f;             // number for the F, d and C lines; 0: not known

    [[nodiscard]] Material material() const noexcept;
};

/// All of them: mirror, the lecture's four, metals, dielectrics.
[[nodiscard]] std::span<const NamedMaterial> namedMaterials() noexcept;

/// Their names, in the same order.
[[nodiscard]] std::span<const std::string_view> materialNames() noexcept;

/// By its name, whatever the case; none when it is unknown.
[[nodiscard]] std::optional<Material> findMaterial(std::string_view name) noexcept;

/// Abbe's number of a dielectric in the table with the same figures; 0 where there is none.
[[nodiscard]] float abbeNumberOf(const Material& material) noexcept;

/// What `--material` takes of smooth materials: a name, or figures. Its messages name the rough and
/// matt ones, too, which materialFromText() of tukor/scene/material_text.h adds.
///
///     mirror:0.9,0.8,0.7                        reflectance for R, G, B; one number for all three
///     metal:0.21,0.485,1.29/3.13,2.23,1.76      eta and k likewise
///     ior:1.5  ior:1.5/0.1,0.2,0.9              index, and absorption in 1/m
///
/// Throws Error: an unknown name lists the known ones and the nearest.
[[nodiscard]] Material parseMaterial(std::string_view text);

[[nodiscard]] Material mirrorMaterial(glm::vec3 tint) noexcept;
[[nodiscard]] Material metalMaterial(glm::vec3 eta, glm::vec3 k) noexcept;
[[nodiscard]] Material dielectricMaterial(float eta, glm::vec3 sigmaA = glm::vec3(0.0f),
                                          int priority = kSolidPriority) noexcept;

/// Throws Error unless every figure of the material's kind is in the range that optics can compute
/// with: tint in [0, 1]; eta in [0.001, 1000]; k in [0, 1000]; sigmaA >= 0 and finite. `name` opens
/// the message.
void checkMaterial(const Material& material, std::string_view name);

/// A metal with reflectance `R0` at normal incidence: what base colours of other programs mean.
///
/// Of all eta, k with that R0, those whose reflectance at other angles is nearest to the
/// approximation R0 + (1 - R0)(1 - cos)^5 that such programs use. R0 is clamped to [0, 0.998].
[[nodiscard]] Material metalFromReflectance(glm::vec3 R0) noexcept;

/// The same with the choice left to the caller: `edgeTint` 0 is the largest eta, 1 the least.
/// [Gulbrandsen 2014]
[[nodiscard]] Material metalFromReflectance(glm::vec3 R0, glm::vec3 edgeTint) noexcept;

}  // namespace tukor
