#include "tukor/scene/picture_decoding.h"

#include <cstdint>

#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/base/parallel.h"
#include "tukor/image/image_size.h"

namespace tukor {

namespace {

constexpr std::uint64_t kMostTexels = std::uint64_t{1} << 29;  // of all pictures: 2 GB

}  // namespace

void decodePictures(std::span<PendingPicture> pictures, std::string_view model, Notes& notes) {
    std::uint64_t total = 0;
    for (PendingPicture& picture : pictures) {
        if (!picture.trouble.empty()) continue;
        try {
            const TexelsSize size = sizeOfTexels(picture.bytes, picture.name);
            checkImageSize(picture.name, size.width, size.height);
            total += std::uint64_t{size.width} * size.height;
        } catch (const Error& error) {
            picture.trouble = error.what();
        }
    }
    if (total > kMostTexels)
        throw Error(fmt::format("{}: its textures have {} texels together; at most {} are read",
                                model, total, kMostTexels));
    parallelFor(0, static_cast<int>(pictures.size()), 1, [&](int begin, int end) {
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
            PendingPicture& picture = pictures[i];
            if (!picture.trouble.empty()) continue;
            try {
                *picture.texels = decodeTexels(picture.bytes, picture.name);
            } catch (const Error& error) {
                picture.trouble = error.what();
            }
        }
    });
    for (const PendingPicture& picture : pictures)
        if (!picture.trouble.empty())
            notes.add("textures that cannot be read, left out", picture.trouble);
}

}  // namespace tukor
