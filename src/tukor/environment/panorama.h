// Panoramas turned, resized, and made of cube maps.
#pragma once
#include "tukor/base/progress.h"
#include "tukor/environment/cube_map.h"
#include "tukor/image/image.h"

namespace tukor {

/// Turned about +Y, counter-clockwise seen from above; exact where the angle is whole pixels, else
/// linear between two.
[[nodiscard]] Image turnedPanorama(const Image& panorama, double radians);
/// The same; exact where the angle is a multiple of 90 degrees.
[[nodiscard]] CubeMap turnedCube(const CubeMap& cube, double radians);

/// Means over areas when it shrinks. When it grows, bilinear between values whose means over the
/// old pixels are those pixels, so that shrinking it again gives them back. The height is half of
/// the width. Black from somewhere on where `progress` asked to stop.
[[nodiscard]] Image resizedPanorama(const Image& panorama, int width,
                                    const Progress& progress = {});

/// Pixels are means of 3 x 3 look-ups; use a cube of at most width / 2 for an area-correct
/// panorama. Stops as resizedPanorama does.
[[nodiscard]] Image panoramaFromCube(const CubeMap& cube, int width, const Progress& progress = {});

/// Pixels such that looking up between them gives what the cube map shows, and that
/// cubeFromEquirect comes near the cube map again. Never negative. Stops likewise.
[[nodiscard]] Image panoramaWithMeansOf(const CubeMap& cube, int width,
                                        const Progress& progress = {});

/// The faces of a cube map between a panorama and a square picture of the sphere of this edge:
/// about twice as many texels to the degree while they take no more than 300 MB, else as many.
[[nodiscard]] int facesBeside(int edge) noexcept;

/// The octahedral map of [Engelhardt & Dachsbacher 2008] with +Y in the middle, +X right and +Z
/// down.
[[nodiscard]] Image octahedralFromCube(const CubeMap& cube, int size);
/// A mirror ball photographed from +Z from far away; black around it. [Debevec 1998]
[[nodiscard]] Image ballFromCube(const CubeMap& cube, int size);

[[nodiscard]] CubeMap cubeFromOctahedral(const Image& picture, int faceSize);
[[nodiscard]] CubeMap cubeFromBall(const Image& picture, int faceSize);

/// Of which the octahedral or ball picture comes near this one. Never negative. Stops as
/// resizedPanorama does.
[[nodiscard]] Image panoramaFromOctahedral(const Image& picture, int width,
                                           const Progress& progress = {});
[[nodiscard]] Image panoramaFromBall(const Image& picture, int width,
                                     const Progress& progress = {});

}  // namespace tukor
