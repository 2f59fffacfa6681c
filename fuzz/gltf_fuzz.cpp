// loadGltf on any bytes, JSON or GLB, at a moment of its animation: a scene or an Error. Files
// beside it do not exist.
#include <cstdint>
#include <span>

#include "tukor/base/error.h"
#include "tukor/scene/gltf_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        (void)tukor::loadGltf("/nowhere/fuzz.gltf", std::as_bytes(std::span(data, size)),
                              {.timeSeconds = 0.5});
    } catch (const tukor::Error&) {  // what a damaged file should give
    }
    return 0;
}
