// OpenEXR images: every compression, scanlines and tiles, several parts and layers.
#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tukor/base/progress.h"
#include "tukor/image/image.h"

namespace tukor {

/// True when the bytes start with OpenEXR's magic number.
[[nodiscard]] bool isExr(std::span<const std::byte> bytes) noexcept;

/// The first part with colour: R, G, B; or a layer of them, or luminance Y with or without chroma.
///
/// The picture is the display window; what the data window leaves of it is black and transparent.
/// Values are as in the file, non-finite and negative ones too, except that a file that declares
/// primaries other than those of Rec. 709 is converted. `name` is for messages. Throws Error.
[[nodiscard]] Image decodeExr(std::span<const std::byte> bytes, std::string_view name);

/// How channels are stored.
enum class ExrPixels {
    full,  // 32-bit floats: differences of pictures and radiance above 65504 survive
    half,  // 16-bit floats: half the size, relative error 5e-4, clipped at 65504
};

/// A named picture inside a file; the empty name is the picture that programs show first.
struct ImageLayer {
    std::string name;
    Image image;
};

/// ZIP-compressed scanlines. All layers have one size; channels are `R`, `G`, `B` (and `A`) or
/// `layer.R` and so on. `metadata` becomes string attributes. No bytes where `progress` asked to
/// stop.
[[nodiscard]] std::vector<std::byte> encodeExr(
    std::span<const ImageLayer> layers, ExrPixels pixels,
    std::span<const std::pair<std::string, std::string>> metadata, const Progress& progress = {});
[[nodiscard]] std::vector<std::byte> encodeExr(
    const Image& image, ExrPixels pixels,
    std::span<const std::pair<std::string, std::string>> metadata, const Progress& progress = {});

/// Lets the library decode on several threads.
void startExrThreads();

}  // namespace tukor
