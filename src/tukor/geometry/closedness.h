// Whether a mesh encloses a solid: what refraction needs, and what to say when it does not.
#pragma once
#include <cstdint>
#include <string>

#include "tukor/geometry/mesh.h"

namespace tukor {

/// Counts of what is wrong with a surface, vertices at the same place counting as one.
struct ClosednessReport {
    std::int64_t openEdges = 0;         // directed edges that no other triangle runs back along
    std::int64_t nonManifoldEdges = 0;  // directed edges that several triangles run along
    std::int64_t degenerate = 0;        // triangles with two corners at one place or no area
    std::int64_t againstNormals = 0;  // corners whose normal points to the far side of the winding
    std::int64_t eulerCharacteristic = 0;  // V - E + F of the welded surface: 2 a sphere, 0 a torus
    double volume = 0.0;                   // m^3 by the divergence theorem; negative inside out

    /// A solid: no edge open, the inside inside.
    [[nodiscard]] bool closed() const noexcept { return openEdges == 0 && volume > 0.0; }
};

[[nodiscard]] ClosednessReport checkClosed(const Mesh& mesh);

/// One sentence on what is wrong and what to do about it; empty for a solid.
[[nodiscard]] std::string warningOf(const ClosednessReport& report);

}  // namespace tukor
