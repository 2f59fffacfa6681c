// The other half of split-sum lighting: what a rough surface makes of uniform light.
#pragma once
#include "tukor/image/image.h"

namespace tukor {

/// Reflectance under uniform light is F0 * r + g, for GGX with height-correlated Smith shadowing
/// and Schlick's Fresnel. [Karis 2013; Heitz 2014]
///
/// Columns run over the cosine of the view, rows over perceptual roughness, from the top; both at
/// (i + 0.5) / size. Within 2e-3.
[[nodiscard]] Image brdfTable(int size);

}  // namespace tukor
