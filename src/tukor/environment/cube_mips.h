// Cube maps at other sizes; in smaller ones a texel is the mean radiance over its solid angle.
#pragma once
#include <vector>

#include "tukor/environment/cube_map.h"

namespace tukor {

/// Whether all texels have one value: means of it would be that value, but not to the last bit.
[[nodiscard]] bool isConstant(const CubeMap& cube) noexcept;

/// The map at a smaller face size; the mean radiance over the sphere is kept.
///
/// Sizes need not divide each other: a texel across a boundary counts by the part that lies inside.
[[nodiscard]] CubeMap shrunkCube(const CubeMap& cube, int faceSize);

/// The map at any face size: shrunkCube, or bilinear look-ups at the new texel centres.
[[nodiscard]] CubeMap resizedCube(const CubeMap& cube, int faceSize);

/// The chain below a cube map as OpenGL numbers it: element 0 is level 1, of half the face size
/// rounded down; the last has one texel a face. Empty for a map of one texel a face.
[[nodiscard]] std::vector<CubeMap> cubeMips(const CubeMap& cube);

}  // namespace tukor
