// What model files say of a surface, in the terms of glTF, and what is made of it here.
#pragma once
#include <string>

#include <glm/glm.hpp>

#include "tukor/materials/material.h"
#include "tukor/scene/notes.h"

namespace tukor {

/// Metallic-roughness with transmission and volume; other formats are translated into it.
struct Surface {
    std::string name;
    glm::vec3 baseColor{1.0f};  // linear Rec. 709
    float metallic = 1.0f;
    float roughness = 1.0f;
    float transmission = 0.0f;
    float ior = 1.5f;
    glm::vec3 attenuationColor{1.0f};  // left of white light after attenuationDistance
    float attenuationDistance = 0.0f;  // m; 0: nothing is absorbed
};

/// At least half metallic: a metal whose reflectance at normal incidence is the base colour. At
/// least half transmissive: a dielectric with that absorption. Else a mirror of the base colour,
/// until diffuse surfaces are rendered. Notes what is lost.
[[nodiscard]] Material materialOf(const Surface& surface, Notes& notes);

}  // namespace tukor
