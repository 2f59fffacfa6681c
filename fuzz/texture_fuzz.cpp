// decodeTexture (.dds, .ktx, .ktx2) on any bytes: a texture or an Error.
#include <cstdint>
#include <span>

#include "tukor/base/error.h"
#include "tukor/image/texture_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        (void)tukor::decodeTexture(std::as_bytes(std::span(data, size)), "fuzz");
    } catch (const tukor::Error&) {  // what a damaged file should give
    }
    return 0;
}
