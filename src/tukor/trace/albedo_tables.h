// How much rough surfaces reflect in all directions together: what keeps energy where facets shadow
// each other.
#pragma once
#include <vector>

#include "tukor/image/image.h"

namespace tukor::trace {

/// What opaque ones reflect: the channels of environment/brdf_table.h at a cosine and a perceptual
/// roughness. Its table is built when first asked for.
[[nodiscard]] glm::vec3 splitAlbedo(float cosTheta, float roughness);

/// What a clear rough interface reflects and transmits when facets are met once.
class ClearAlbedo {
public:
    /// Of `eta` = etaT / etaI.
    explicit ClearAlbedo(float eta);

    /// `alpha` is GGX's.
    [[nodiscard]] float at(float cosTheta, float alpha) const noexcept;

private:
    std::vector<float> table_;  // [alpha][cosine]
};

}  // namespace tukor::trace
