// What is known of each pixel's centre beside its radiance.
#pragma once
#include <span>
#include <vector>

#include "tukor/trace/frame.h"

namespace tukor::trace {

/// One picture per layer, named `depth`, `normal`, `material`, `bounces`.
[[nodiscard]] std::vector<ImageLayer> traceLayers(const Frame& frame,
                                                  std::span<const AovLayer> layers);

}  // namespace tukor::trace
