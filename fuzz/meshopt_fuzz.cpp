// meshoptDecoded on any stream, count, stride, mode and filter: bytes or an Error.
#include <cstdint>
#include <span>
#include <string>

#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/scene/gltf_meshopt.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const std::string name = "fuzz";
    constexpr const char* kModes[] = {"ATTRIBUTES", "TRIANGLES", "INDICES"};
    constexpr const char* kFilters[] = {"NONE", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL"};
    if (size < 4) return 0;
    // Mode and filter, stride, count; then the stream.
    const std::string text = fmt::format(
        R"({{"mode": "{}", "filter": "{}", "byteStride": {}, "count": {}}})", kModes[data[0] % 3],
        kFilters[data[0] / 3 % 4], data[1], data[2] | data[3] << 8);
    const tukor::JsonDocument extension = tukor::parseJson(name, std::as_bytes(std::span(text)));
    try {
        (void)tukor::meshoptDecoded({extension, name},
                                    std::as_bytes(std::span(data, size)).subspan(4));
    } catch (const tukor::Error&) {  // what a damaged stream should give
    }
    return 0;
}
