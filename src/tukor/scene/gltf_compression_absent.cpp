// Stands in for Draco and meshoptimizer in browsers, where the page unpacks files before it hands
// them over.
#ifdef __EMSCRIPTEN__
#include "tukor/scene/gltf_draco.h"
#include "tukor/scene/gltf_meshopt.h"

namespace tukor {

Mesh dracoDecoded(const JsonItem& extension, std::span<const std::byte>, std::size_t, std::size_t) {
    extension.fail("Draco compression that extensionsUsed does not name");
}

std::vector<std::byte> meshoptDecoded(const JsonItem& extension, std::span<const std::byte>) {
    extension.fail("meshopt compression that extensionsUsed does not name");
}

}  // namespace tukor
#endif
