// Where single precision meets a surface from the wrong side, or misses it: one ray in a million,
// at edges.
#pragma once
#include "tukor/trace/frame.h"

namespace tukor::trace {

/// What the ray really meets where `hit`, nothing (surface -1) or a surface from a side that the
/// path says it is not on, comes of rounding; `hit` itself where it does not: there the model is at
/// fault. May move the ray's origin within its triangle.
[[nodiscard]] RayHit withoutRounding(const Frame& frame, transport::Branch& ray,
                                     const RayHit& hit) noexcept;

}  // namespace tukor::trace
