// Stands in for zstd in browsers, where the page expands files before it hands them over.
#ifdef __EMSCRIPTEN__
#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/image/zstd_frame.h"

namespace tukor {

std::size_t expandZstd(std::span<const std::byte>, std::span<std::byte>, std::string_view name) {
    throw Error(fmt::format("{}: compressed by zstd", name));
}

}  // namespace tukor
#endif
