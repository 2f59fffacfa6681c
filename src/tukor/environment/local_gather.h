// Convolution with lobes too sharp for spherical harmonics.
#pragma once
#include "tukor/environment/cube_map.h"
#include "tukor/environment/lobe.h"
#include "tukor/image/image.h"

namespace tukor {

/// The panorama convolved with a ggx lobe of alpha below 0.01, sampled around each texel's
/// direction in rings of equal weight; the wide rings of the tail look up smaller panoramas.
[[nodiscard]] CubeMap gatheredCube(const Image& panorama, const Lobe& lobe, int faceSize);

}  // namespace tukor
