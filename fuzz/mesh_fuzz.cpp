// The readers of OBJ, MTL, PLY and STL on any bytes: a scene or an Error.
#include <cstdint>
#include <span>

#include "tukor/base/error.h"
#include "tukor/scene/mtl_file.h"
#include "tukor/scene/obj_file.h"
#include "tukor/scene/ply_file.h"
#include "tukor/scene/stl_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::span<const std::byte> bytes = std::as_bytes(std::span(data, size));
    tukor::Notes notes;
    tukor::FileTextures textures("/nowhere/fuzz.obj", notes);
    (void)tukor::readMtl(bytes, textures, notes);
    textures.decode();
    for (const auto load : {tukor::loadObj, tukor::loadPly, tukor::loadStl}) {
        try {
            (void)load("/nowhere/fuzz.obj", bytes, {});
        } catch (const tukor::Error&) {  // what a damaged file should give
        }
    }
    return 0;
}
