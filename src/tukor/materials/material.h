// What a surface is made of: three kinds of ideal smooth matter, as plain data.
#pragma once
#include <memory>

#include <glm/glm.hpp>

namespace tukor {

/// What happens at the surface; which fields of Material count.
enum class MaterialKind {
    mirror,      // reflects `tint`, whatever the angle
    metal,       // index eta + i k per channel; what is refracted is lost
    dielectric,  // index eta.x at 587.6 nm, absorption sigmaA inside
};

struct Finish;  // tukor/scene/finish.h

struct Material {
    MaterialKind kind = MaterialKind::mirror;
    glm::vec3 tint{1.0f};     // reflectance of a mirror, in [0, 1]
    glm::vec3 eta{1.5f};      // index for R, G, B against vacuum; a dielectric has all three alike
    glm::vec3 k{0.0f};        // extinction for R, G, B, >= 0; metals only
    glm::vec3 sigmaA{0.0f};   // absorption inside a dielectric, 1/m, >= 0
    float colourSize = 0.0f;  // m across of what sigmaA was chosen for: what has another size
                              // absorbs as much on the whole; 0: sigmaA is what it is
    float dispersion = 0.0f;  // of a dielectric, 20 over Abbe's number; 0: none
    int priority = 0;  // where dielectrics overlap, the highest priority is the one that is there

    /// Rough, diffuse or textured surfaces; null: ideally smooth. Then the rest is what is nearest
    /// among those, and for solids that let light in, what is inside.
    std::shared_ptr<const Finish> finish = nullptr;

    friend bool operator==(const Material&, const Material&) = default;
};

}  // namespace tukor
