// Cube maps coarser than the panorama they are made of.
#pragma once
#include "tukor/environment/cube_map.h"
#include "tukor/image/image.h"

namespace tukor {

/// Each texel is the mean over its solid angle of the panorama's pixels, taken as areas of one
/// value.
///
/// Pixels are clipped against texels: bench/cube_conversion finds photographs within 1e-3 of exact
/// means, white noise within 2.2e-3.
[[nodiscard]] CubeMap areaCubeFromEquirect(const Image& panorama, int faceSize);

}  // namespace tukor
