// dracoDecoded on any stream: a mesh or an Error.
#include <cstdint>
#include <span>
#include <string>

#include "tukor/base/error.h"
#include "tukor/scene/gltf_draco.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const std::string name = "fuzz";
    static const nlohmann::json extension =
        nlohmann::json::parse(R"({"attributes": {"POSITION": 0, "NORMAL": 1}})");
    try {
        (void)tukor::dracoDecoded({extension, name}, std::as_bytes(std::span(data, size)), 10'000,
                                  10'000);
    } catch (const tukor::Error&) {  // what a damaged stream should give
    }
    return 0;
}
