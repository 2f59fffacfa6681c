#include "tukor/scene/model_file.h"

#include <filesystem>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "tukor/base/error.h"
#include "tukor/base/file.h"
#include "tukor/geometry/shapes.h"
#include "tukor/materials/materials.h"
#include "tukor/scene/gltf_file.h"

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

}  // namespace

Scene loadModel(const std::string& nameOrPath, const ModelOptions& options) {
    const fs::path path(nameOrPath);
    if (!path.has_parent_path() && !path.has_extension()) {
        if (std::optional<std::vector<ShapePart>> shape = makeShape(nameOrPath))
            return sceneOf(std::move(*shape), options);
        if (!fs::exists(path))
            throw Error(fmt::format("{}: no such model; expected a file or one of {}", nameOrPath,
                                    fmt::join(shapeNames(), ", ")));
    }
    const MappedFile file(path);
    if (file.bytes().empty()) throw Error(fmt::format("{}: an empty file", nameOrPath));
    const std::string extension = lowerExtension(path);
    if (extension == ".gltf" || extension == ".glb" || looksLikeGltf(file.bytes()))
        return loadGltf(path, file.bytes(), options);
    throw Error(fmt::format("{}: not a model of a known format", nameOrPath));
}

}  // namespace tukor
