// dracoDecoded on any stream: a mesh or an Error.
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "tukor/base/error.h"
#include "tukor/scene/gltf_draco.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const std::string name = "fuzz";
    constexpr std::string_view text = R"({"attributes": {"POSITION": 0, "NORMAL": 1}})";
    static const tukor::JsonDocument extension =
        tukor::parseJson(name, std::as_bytes(std::span(text)));
    try {
        (void)tukor::dracoDecoded({extension, name}, std::as_bytes(std::span(data, size)), 10'000,
                                  10'000);
    } catch (const tukor::Error&) {  // what a damaged stream should give
    }
    return 0;
}
