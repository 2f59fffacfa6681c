// Which pixels surfaces may be seen in, by conservative rasterization: the others need no rays.
#pragma once
#include <cstdint>
#include <vector>

#include "tukor/trace/frame.h"

namespace tukor::trace {

/// A byte for every pixel, row by row from the top; 0 where no camera ray within the pixel meets a
/// surface. Nearly all such pixels are 0, triangles of many pixels included.
///
/// With all threads, in time linear in the triangles. [Hasselgren et al. 2005]
[[nodiscard]] std::vector<std::uint8_t> silhouetteOf(const SurfaceTable& surfaces,
                                                     const RayGenerator& camera, int width,
                                                     int height);

}  // namespace tukor::trace
