// decodePng on any bytes: an image or an Error.
#include <cstdint>
#include <span>

#include "tukor/base/error.h"
#include "tukor/image/png_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        (void)tukor::decodePng(std::as_bytes(std::span(data, size)), "fuzz");
    } catch (const tukor::Error&) {  // what a damaged file should give
    }
    return 0;
}
