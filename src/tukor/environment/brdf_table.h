// The other half of split-sum lighting: what a rough surface makes of uniform light.
#pragma once
#include "tukor/base/progress.h"
#include "tukor/image/image.h"

namespace tukor {

/// Reflectance under uniform light is F0 * r + g, for GGX with height-correlated Smith shadowing
/// and Schlick's Fresnel; r and g are the first two channels. [Karis 2013; Heitz 2014] The third is
/// the reflectance of sheen, fibres of [Estevez & Kulla 2017], that takes nothing from what is
/// below.
///
/// Columns run over the cosine of the view, rows over perceptual roughness, from the top; both at
/// (i + 0.5) / size. Within 1e-4. An empty image where `progress` asked to stop.
[[nodiscard]] Image brdfTable(int size, const Progress& progress = {});

/// The same for renderers, which want the ends: columns at cosines of (i / (size - 1))^2, rows at
/// roughnesses of i / (size - 1).
[[nodiscard]] Image brdfNodeTable(int size);

}  // namespace tukor
