// Pictures in and out of files: the format is found by content when reading, by extension when
// writing.
#pragma once
#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>

#include "tukor/image/image.h"

namespace tukor {

/// Reads OpenEXR, Radiance, PNG or JPEG, whatever the file is called.
///
/// OpenEXR and Radiance values are as in the file, non-finite and negative ones too. Throws Error.
[[nodiscard]] Image loadImage(const std::filesystem::path& path);

/// The same from memory; `name` stands for the file in messages.
[[nodiscard]] Image decodeImage(std::span<const std::byte> bytes, std::string_view name);

}  // namespace tukor
