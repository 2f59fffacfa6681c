// What a screen is sent: the choice of tone mapper, and 8- and 16-bit sRGB pixels.
#pragma once
#include <array>
#include <cstdint>
#include <string_view>
#include <utility>

#include <glm/glm.hpp>

namespace tukor {

/// How radiance above 1 is brought onto the screen; see image/tonemap.h for what each does.
enum class Tonemap { none, reinhard, aces, agx, neutral };

inline constexpr std::array<std::pair<Tonemap, std::string_view>, 5> kTonemapSpellings{{
    {Tonemap::none, "none"},
    {Tonemap::reinhard, "reinhard"},
    {Tonemap::aces, "aces"},
    {Tonemap::agx, "agx"},
    {Tonemap::neutral, "neutral"},
}};

/// Exposed and tone mapped, linear, clipped to [0, 1]; non-finite and negative components count as
/// the nearest displayable ones, NaN as 0.
[[nodiscard]] glm::vec3 displayed(glm::vec3 radiance, Tonemap tonemap, float exposureFactor);

/// The nearest 8-bit sRGB code of a linear component, clipped to [0, 1]; 0 for NaN. Exact: equals
/// rounding the transfer function in double precision.
[[nodiscard]] std::uint8_t srgb8(float linear) noexcept;

/// The linear value of each 8-bit sRGB code.
[[nodiscard]] const std::array<float, 256>& linearFromSrgb8() noexcept;

}  // namespace tukor
