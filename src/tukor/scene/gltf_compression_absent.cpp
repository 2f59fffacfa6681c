// Stands in for Draco and meshoptimizer where they are not built: in browsers.
#ifdef __EMSCRIPTEN__
#include "tukor/scene/gltf_draco.h"
#include "tukor/scene/gltf_meshopt.h"

namespace tukor {

Mesh dracoDecoded(const JsonItem& extension, std::span<const std::byte>, std::size_t, std::size_t) {
    extension.fail("Draco compression is not supported in browsers");
}

std::vector<std::byte> meshoptDecoded(const JsonItem& extension, std::span<const std::byte>) {
    extension.fail("meshopt compression is not supported in browsers");
}

}  // namespace tukor
#endif
