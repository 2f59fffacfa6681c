// meshoptDecoded on any stream, count, stride, mode and filter: bytes or an Error.
#include <cstdint>
#include <span>
#include <string>

#include "tukor/base/error.h"
#include "tukor/scene/gltf_meshopt.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const std::string name = "fuzz";
    constexpr const char* kModes[] = {"ATTRIBUTES", "TRIANGLES", "INDICES"};
    constexpr const char* kFilters[] = {"NONE", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL"};
    if (size < 4) return 0;
    // Mode and filter, stride, count; then the stream.
    const nlohmann::json extension = {{"mode", kModes[data[0] % 3]},
                                      {"filter", kFilters[data[0] / 3 % 4]},
                                      {"byteStride", data[1]},
                                      {"count", data[2] | data[3] << 8}};
    try {
        (void)tukor::meshoptDecoded({extension, name},
                                    std::as_bytes(std::span(data, size)).subspan(4));
    } catch (const tukor::Error&) {  // what a damaged stream should give
    }
    return 0;
}
