// Panoramas turned, resized, and made of cube maps; and the orientations that programs expect.
#pragma once
#include <array>
#include <numbers>
#include <string_view>
#include <utility>

#include "tukor/base/options.h"
#include "tukor/environment/cube_map.h"
#include "tukor/image/image.h"

namespace tukor {

/// Programs by the direction that they see in the middle of a panorama, in this project's axes:
/// models exchanged as glTF stand the same in all of them.
enum class Orientation { opengl, blender, three, openexr, filament, unreal };

inline constexpr std::array<std::pair<Orientation, std::string_view>, 6> kOrientationSpellings = {
    {{Orientation::opengl, "opengl"},      // -Z, as in this project
     {Orientation::blender, "blender"},    // +X
     {Orientation::three, "three"},        // +X
     {Orientation::openexr, "openexr"},    // +Z
     {Orientation::filament, "filament"},  // +Z
     {Orientation::unreal, "unreal"}}};    // +X

/// Radians about +Y, counter-clockwise seen from above, by which a panorama in that orientation
/// must be turned to be in this project's.
[[nodiscard]] double turnFrom(Orientation orientation) noexcept;

/// Turned about +Y, counter-clockwise seen from above; exact where the angle is whole pixels, else
/// linear between two.
[[nodiscard]] Image turnedPanorama(const Image& panorama, double radians);
[[nodiscard]] CubeMap turnedCube(const CubeMap& cube, double radians);

/// Means over areas when it shrinks, bilinear when it grows. The height is half of the width.
[[nodiscard]] Image resizedPanorama(const Image& panorama, int width);

/// Pixels are means of 3 x 3 look-ups; use a cube of at most width / 2 for an area-correct
/// panorama.
[[nodiscard]] Image panoramaFromCube(const CubeMap& cube, int width);

/// The octahedral map of [Engelhardt & Dachsbacher 2008] with +Y in the middle, +X right and +Z
/// down.
[[nodiscard]] Image octahedralFromCube(const CubeMap& cube, int size);
/// A mirror ball photographed from +Z from far away; black around it. [Debevec 1998]
[[nodiscard]] Image ballFromCube(const CubeMap& cube, int size);

[[nodiscard]] CubeMap cubeFromOctahedral(const Image& picture, int faceSize);
[[nodiscard]] CubeMap cubeFromBall(const Image& picture, int faceSize);

}  // namespace tukor
