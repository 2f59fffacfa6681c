// Directions from which ground is lit, for shadows by asking: many where the light is strong.
#pragma once
#include <span>
#include <vector>

#include "tukor/environment/cube_map.h"
#include "tukor/image/image.h"

namespace tukor {

/// Light on a surface that faces +Y.
struct LitDirection {
    glm::vec3 direction{0.0f};   // unit, from where it comes; +Y up
    glm::vec3 irradiance{0.0f};  // of the surface

    friend bool operator==(const LitDirection&, const LitDirection&) = default;
};

/// `count`, a power of two, of about equal brightness, which together are the light of a panorama
/// or cube map from above and of `lamps`. Any 2^k of them from a multiple of 2^k on are spread over
/// all. None where all is dark.
[[nodiscard]] std::vector<LitDirection> litDirections(const Image& panorama,
                                                      std::span<const LitDirection> lamps,
                                                      std::size_t count);
[[nodiscard]] std::vector<LitDirection> litDirections(const CubeMap& cube,
                                                      std::span<const LitDirection> lamps,
                                                      std::size_t count);

}  // namespace tukor
