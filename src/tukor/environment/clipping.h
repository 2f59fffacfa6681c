// What files that end at some radiance take from an environment.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>

#include "tukor/image/image.h"
#include "tukor/image/texture_file.h"

namespace tukor {

/// Of a picture, or of several. Light is radiance by solid angle, on one common scale.
struct Clipping {
    float most = 0.0f;       // the largest value that the format holds
    std::size_t pixels = 0;  // with a component above it
    double lost = 0.0;       // the light above it
    double whole = 0.0;      // all light
};

/// The largest value of a format that clips radiance silently; infinite for float, and for rgba8,
/// which is to be looked at.
[[nodiscard]] float largestOf(TexelFormat format) noexcept;

enum class PixelAreas { equal, equirect, face };

/// Adds a picture; `areas` says how much of the sphere pixels see.
void addClipping(Clipping& clipping, const Image& image, PixelAreas areas);

/// `3 pixels above 65504, the most that half holds, were clipped: 12 % of the light`
[[nodiscard]] std::string sentenceOf(const Clipping& clipping, std::string_view format);

}  // namespace tukor
