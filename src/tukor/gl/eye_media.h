// Which dielectrics an eye is inside of.
#pragma once
#include <cstdint>
#include <span>

#include "tukor/geometry/bvh.h"

namespace tukor::gl {

/// The set of media around a point, from the surfaces that rays cross on their way out;
/// `insideOfPart` is the set behind each part's surface. Two of three rays decide.
[[nodiscard]] std::uint32_t mediaAround(glm::vec3 point, const Bvh& bvh,
                                        std::span<const std::uint32_t> insideOfPart);

}  // namespace tukor::gl
