#include "tukor/image/image_size.h"

#include <fmt/format.h>

#include "tukor/base/error.h"

namespace tukor {

void checkImageSize(std::string_view name, std::uint64_t width, std::uint64_t height) {
    if (width == 0 || height == 0)
        throw Error(
            fmt::format("{}: {} x {} pixels; expected at least 1 x 1", name, width, height));
    if (width > kMaxPixels || height > kMaxPixels || width * height > kMaxPixels)
        throw Error(fmt::format("{}: {} x {} pixels; at most {} pixels are accepted", name, width,
                                height, kMaxPixels));
}

void checkImageFits(std::string_view name, std::uint64_t width, std::uint64_t height,
                    std::uint64_t fileBytes, std::uint64_t pixelsPerByte) {
    if (width * height > kTrustedPixels && width * height / pixelsPerByte > fileBytes)
        throw Error(fmt::format("{}: {} x {} pixels cannot be in {} bytes; the file is damaged",
                                name, width, height, fileBytes));
}

}  // namespace tukor
