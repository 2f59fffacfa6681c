// Cube maps coarser than the panorama they are made of.
#pragma once
#include "tukor/environment/cube_map.h"
#include "tukor/image/image.h"

namespace tukor {

/// Each texel is the mean over its solid angle of the panorama's pixels, taken as areas of one
/// value.
///
/// The four faces around the horizon by clipping pixels against texels, the two others by samples.
/// White noise is met to 1 %, photographs to 0.2 %.
[[nodiscard]] CubeMap areaCubeFromEquirect(const Image& panorama, int faceSize);

}  // namespace tukor
