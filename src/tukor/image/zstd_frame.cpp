#include "tukor/image/zstd_frame.h"

#include <fmt/format.h>
#include <zstd.h>

#include "tukor/base/error.h"

namespace tukor {

std::size_t expandZstd(std::span<const std::byte> frame, std::span<std::byte> bytes,
                       std::string_view name) {
    const std::size_t got = ZSTD_decompress(bytes.data(), bytes.size(), frame.data(), frame.size());
    if (ZSTD_isError(got) != 0)
        throw Error(fmt::format("{}: damaged KTX2 file: {}", name, ZSTD_getErrorName(got)));
    return got;
}

}  // namespace tukor
