#include "tukor/scene/model_file.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

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

enum class Format { gltf, ply, obj, stl, others };

std::optional<Format> formatOfName(const fs::path& path) {
    const std::string extension = lowerExtension(path);
    if (extension == ".gltf" || extension == ".glb") return Format::gltf;
    if (extension == ".ply") return Format::ply;
    if (extension == ".obj") return Format::obj;
    if (extension == ".stl") return Format::stl;
    if (assimpReads(extension)) return Format::others;
    return std::nullopt;
}

// By what the file begins with, where formats have a mark; else by its extension.
Format formatOf(const fs::path& path, std::span<const std::byte> bytes) {
    if (startsWith(bytes, "glTF")) return Format::gltf;
    if (startsWith(bytes, "ply\n") || startsWith(bytes, "ply\r")) return Format::ply;
    if (const std::optional<Format> named = formatOfName(path)) return *named;
    if (looksLikeGltf(bytes)) return Format::gltf;
    throw Error(
        fmt::format("{}: not a model of a known format; expected .gltf .glb .obj .ply .stl, "
                    "another that Assimp reads, or one of the shapes {}",
                    path.string(), fmt::join(shapeNames(), ", ")));
}

MappedFile opened(const std::string& path) {
    MappedFile file(path);
    if (file.bytes().empty()) throw Error(fmt::format("{}: an empty file", path));
    return file;
}

}  // namespace

bool meansShape(const std::string& nameOrPath) {
    const fs::path path(nameOrPath);
    if (path.has_parent_path() || path.has_extension()) return false;
    const std::vector<std::string_view> shapes = shapeNames();
    if (std::find(shapes.begin(), shapes.end(), nameOrPath) != shapes.end()) return true;
#ifdef __EMSCRIPTEN__
    constexpr bool there = false;  // files in memory have extensions
#else
    const bool there = fs::exists(path);
#endif
    if (!there)
        throw Error(fmt::format("{}: no such model; expected a file or one of {}", nameOrPath,
                                fmt::join(shapes, ", ")));
    return false;
}

Scene loadModel(const std::string& nameOrPath, const ModelOptions& options) {
    if (meansShape(nameOrPath)) return sceneOf(*makeShape(nameOrPath), options);
    const MappedFile file = opened(nameOrPath);
    const fs::path path(nameOrPath);
    switch (formatOf(path, file.bytes())) {
        case Format::gltf:
            return loadGltf(path, file.bytes(), options);
        case Format::ply:
            return loadPly(path, file.bytes(), options);
        case Format::obj:
            return loadObj(path, file.bytes(), options);
        case Format::stl:
            return loadStl(path, file.bytes(), options);
        case Format::others:
            break;
    }
    return loadThroughAssimp(path, file.bytes(), options);
}

bool hasModelExtension(const fs::path& path) {
    return formatOfName(path).has_value();
}

ModelChoices choicesOf(const std::string& nameOrPath) {
    if (meansShape(nameOrPath)) return {};
    const MappedFile file = opened(nameOrPath);
    if (formatOf(nameOrPath, file.bytes()) != Format::gltf) return {};
    return gltfChoices(nameOrPath, file.bytes());
}

double animationSeconds(const std::string& nameOrPath, const std::string& animation) {
    if (meansShape(nameOrPath)) return 0.0;
    const MappedFile file = opened(nameOrPath);
    if (formatOf(nameOrPath, file.bytes()) != Format::gltf) return 0.0;
    return gltfSeconds(nameOrPath, file.bytes(), animation);
}

}  // namespace tukor
