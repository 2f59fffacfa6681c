// Equirectangular panoramas: where their pixels look, and cube maps from them.
#pragma once
#include <glm/glm.hpp>

#include "tukor/base/progress.h"
#include "tukor/environment/cube_map.h"
#include "tukor/image/image.h"

namespace tukor {

/// Place in the panorama, (0, 0) its top left corner and (1, 1) its bottom right one, of a
/// direction of any non-zero length. The middle is -Z, +X lies to the right of it, the top row is
/// +Y.
[[nodiscard]] glm::vec2 equirectFromDirection(glm::vec3 direction) noexcept;

/// The unit direction of a place in the panorama.
[[nodiscard]] glm::vec3 directionFromEquirect(glm::vec2 place) noexcept;

/// Bilinear radiance of a panorama; wraps around, and over the poles to the far side.
[[nodiscard]] glm::vec3 equirectRadiance(const Image& panorama, glm::vec3 direction) noexcept;

/// Texels of a face that has as many to the degree as the panorama has where it is wide.
[[nodiscard]] float equirectDensity(int width) noexcept;

/// The least power of two that is at least that, so that no face has fewer texels to the
/// degree than the panorama: 512 for a width of 1024.
[[nodiscard]] int faceSizeForEquirect(int width) noexcept;

/// A cube map of a panorama; `faceSize` is at least 1.
///
/// Where the faces are coarser than the panorama (faceSize < width / pi), a texel is the mean over
/// its area. Where they are finer, texels are chosen so that a bilinear look-up in the cube comes
/// as close as it can, in the least squares sense, to the bilinear look-up in the panorama: the
/// means or centres of texels would be blurred a second time by the look-up. Never leaves the range
/// of the pixels nearby by more than a quarter; a constant stays constant.
///
/// Black from somewhere on where `progress` asked to stop.
[[nodiscard]] CubeMap cubeFromEquirect(const Image& panorama, int faceSize,
                                       const Progress& progress = {});

}  // namespace tukor
