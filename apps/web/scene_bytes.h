// A scene as bytes, handed from one WebAssembly module to another: the page's own format, never a
// file.
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "tukor/scene/scene.h"

namespace tukor::web {

/// Parts and warnings, as ideal smooth surfaces; no cameras.
[[nodiscard]] std::vector<std::byte> bytesFromScene(const Scene& scene);

/// The inverse. Both modules are built together: nothing is checked.
[[nodiscard]] Scene sceneFromBytes(std::span<const std::byte> bytes);

}  // namespace tukor::web
