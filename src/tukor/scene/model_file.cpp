#include "tukor/scene/model_file.h"

#include <cstring>
#include <filesystem>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "tukor/base/error.h"
#include "tukor/base/file.h"
#include "tukor/geometry/shapes.h"
#include "tukor/materials/materials.h"
#include "tukor/scene/assimp_file.h"
#include "tukor/scene/gltf_file.h"
#include "tukor/scene/obj_file.h"
#include "tukor/scene/ply_file.h"
#include "tukor/scene/stl_file.h"

namespace tukor {

namespace {

namespace fs = std::filesystem;

Scene sceneOf(std::vector<ShapePart> shapeParts, const ModelOptions& options) {
    Scene scene;
    for (ShapePart& shape : shapeParts) {
        const bool named = !shape.material.empty();
        scene.parts.push_back({shape.name, shape.material,
                               parseMaterial(named ? shape.material : options.material),
                               std::move(shape.mesh)});
    }
    return scene;
}

bool startsWith(std::span<const std::byte> bytes, std::string_view text) noexcept {
    return bytes.size() >= text.size() && std::memcmp(bytes.data(), text.data(), text.size()) == 0;
}

// By what the file begins with, where formats have a mark; else by its extension.
Scene loadFile(const fs::path& path, std::span<const std::byte> bytes,
               const ModelOptions& options) {
    const std::string extension = lowerExtension(path);
    if (startsWith(bytes, "glTF") || extension == ".gltf" || extension == ".glb")
        return loadGltf(path, bytes, options);
    if (startsWith(bytes, "ply\n") || startsWith(bytes, "ply\r") || extension == ".ply")
        return loadPly(path, bytes, options);
    if (extension == ".obj") return loadObj(path, bytes, options);
    if (extension == ".stl") return loadStl(path, bytes, options);
    if (assimpReads(extension)) return loadThroughAssimp(path, bytes, options);
    if (looksLikeGltf(bytes)) return loadGltf(path, bytes, options);
    throw Error(
        fmt::format("{}: not a model of a known format; expected .gltf .glb .obj .ply .stl, "
                    "another that Assimp reads, or one of the shapes {}",
                    path.string(), fmt::join(shapeNames(), ", ")));
}

}  // namespace

Scene loadModel(const std::string& nameOrPath, const ModelOptions& options) {
    const fs::path path(nameOrPath);
    if (!path.has_parent_path() && !path.has_extension()) {
        if (std::optional<std::vector<ShapePart>> shape = makeShape(nameOrPath))
            return sceneOf(std::move(*shape), options);
#ifdef __EMSCRIPTEN__
        constexpr bool there = false;  // files in memory have extensions
#else
        const bool there = fs::exists(path);
#endif
        if (!there)
            throw Error(fmt::format("{}: no such model; expected a file or one of {}", nameOrPath,
                                    fmt::join(shapeNames(), ", ")));
    }
    const MappedFile file(path);
    if (file.bytes().empty()) throw Error(fmt::format("{}: an empty file", nameOrPath));
    return loadFile(path, file.bytes(), options);
}

}  // namespace tukor
