// The pictures of a model's textures, decoded together.
#pragma once
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tukor/image/texels.h"
#include "tukor/scene/notes.h"

namespace tukor {

/// A picture that textures ask for; `texels` are empty until it is decoded.
struct PendingPicture {
    std::shared_ptr<const void> owner;  // of the bytes; null where somebody else keeps them
    std::span<const std::byte> bytes;   // of a PNG or JPEG
    std::string name;                   // for messages
    std::string trouble;                // why the bytes cannot be had; empty where they can
    std::shared_ptr<Texels> texels;
};

/// Decodes all, on all cores. What cannot be read is noted, and stays empty. Throws Error, opened
/// by `model`, where they are too large together.
void decodePictures(std::span<PendingPicture> pictures, std::string_view model, Notes& notes);

}  // namespace tukor
