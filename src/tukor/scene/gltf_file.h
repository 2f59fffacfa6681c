// glTF 2.0 and GLB: meshes, nodes, cameras, materials.
#pragma once
#include <filesystem>
#include <span>

#include "tukor/scene/model_file.h"

namespace tukor {

/// Whether a file begins like a GLB, or with JSON.
[[nodiscard]] bool looksLikeGltf(std::span<const std::byte> bytes) noexcept;

/// The default scene of a glTF file with the contents `bytes`. Throws Error.
///
/// Buffers may only come from the file itself or from files below its folder. What is not rendered
/// as the file asks is listed in the scene's warnings.
[[nodiscard]] Scene loadGltf(const std::filesystem::path& path, std::span<const std::byte> bytes,
                             const ModelOptions& options = {});

/// The looks and animations that such a file offers. Throws Error.
[[nodiscard]] ModelChoices gltfChoices(const std::filesystem::path& path,
                                       std::span<const std::byte> bytes);

/// How long an animation of such a file lasts, in seconds; which as in ModelOptions. Throws Error.
[[nodiscard]] double gltfSeconds(const std::filesystem::path& path,
                                 std::span<const std::byte> bytes, std::string_view animation);

}  // namespace tukor
