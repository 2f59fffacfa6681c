// The built-in environments: computed light, at any resolution.
#pragma once
#include "tukor/environment/cube_map.h"

namespace tukor {

/// A photographer's studio for jewellery and glass, at texel size `faceSize`.
///
/// A large warm key light from the upper left front, a broad fill from the right, cool strip lights
/// behind, lamps for sparkle, black flags that draw the edges of clear glass, and a backdrop that
/// darkens upwards. Lights are 2 to 20, the backdrop about 0.3.
[[nodiscard]] CubeMap studioCube(int faceSize);

struct SkyOptions {
    float sunElevation = 0.65f;  // radians above the horizon, in (0, pi/2]
    float sunAzimuth = 0.6f;     // radians from +Z towards +X: to the right behind a camera at +Z
    float turbidity = 2.6f;      // haze: 2 very clear, 6 hazy; the fit holds from 1.9 to 10
    float sunSize = 1.0f;        // factor on the sun's true angular radius; its irradiance is kept
    float groundAlbedo = 0.22f;  // reflectance of the plain below the horizon
};

/// The angular radius of the sun from the earth, in radians: 0.2666 degrees.
inline constexpr float kSunRadius = 0.004653f;

/// A clear sky with its sun over a plain. [Preetham et al. 1999]
///
/// Unit radiance is 25,000 cd/m^2, so that the sky is about 0.3 and the sun's disc stays below the
/// 65504 of half floats.
[[nodiscard]] CubeMap skyCube(int faceSize, const SkyOptions& options = {});

[[nodiscard]] glm::vec3 sunDirection(const SkyOptions& options) noexcept;

/// Adds a uniform disc; the sum over the map is exactly radiance times the disc's solid angle at
/// any resolution, also where the disc is smaller than a texel.
void addDisc(CubeMap& cube, glm::vec3 direction, float angularRadius, glm::vec3 radiance);

}  // namespace tukor
