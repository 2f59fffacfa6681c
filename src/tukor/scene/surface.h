// What model files say of a surface, in the terms of glTF, and what is made of it here.
#pragma once
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

/// Whether it is one of the ideal smooth surfaces of Material, to which no finish adds anything:
/// polished metal, or clear glass with an inside.
[[nodiscard]] bool isIdeal(const Surface& surface) noexcept;

[[nodiscard]] bool hasTextures(const Surface& surface) noexcept;

/// An ideal surface: a metal whose reflectance at normal incidence is the base colour, or a
/// dielectric with that absorption. Else the nearest of these, with the finish.
[[nodiscard]] Material materialOf(const Surface& surface);

}  // namespace tukor
