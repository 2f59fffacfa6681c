// Scenes from built-in shapes and model files, whatever their format.
#pragma once
#include <filesystem>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "tukor/scene/scene.h"

namespace tukor {

struct ModelOptions {
    /// Where a file gives no normals, triangles meeting at less than this angle look smooth.
    float creaseAngle = std::numbers::pi_v<float> / 6.0f;  // radians; 30 degrees
    /// Of parts for which neither shape nor file names a material; anything parseMaterial() takes.
    std::string material = "gold";
    /// A moment of the file's animation; none: as modelled. glTF only.
    std::optional<double> timeSeconds = std::nullopt;
    /// Of KHR_materials_variants, by name; empty: the file's own choice.
    std::string variant = {};
    /// By name, or else by number from 0; empty: the first.
    std::string animation = {};
};

/// A built-in shape by name, or a model file: glTF, GLB, OBJ, PLY, STL, or what Assimp reads.
///
/// A file wins over a shape only when it is given with a folder or an extension. The format is told
/// by the file's first bytes, then by its extension. A file can name others beside or below itself
/// but none elsewhere. Throws Error.
[[nodiscard]] Scene loadModel(const std::string& nameOrPath, const ModelOptions& options = {});

/// Whether loadModel() takes that for a built-in shape, not for a file. Throws Error where there is
/// neither.
[[nodiscard]] bool meansShape(const std::string& nameOrPath);

/// Whether the extension is that of a model: .gltf .glb .obj .ply .stl, or one that Assimp reads.
[[nodiscard]] bool hasModelExtension(const std::filesystem::path& path);

/// What ModelOptions can choose from, by name; an animation that has none is empty.
struct ModelChoices {
    std::vector<std::string> variants;
    std::vector<std::string> animations;
};

/// Of a glTF file; of other models nothing. Throws Error, as loadModel does.
[[nodiscard]] ModelChoices choicesOf(const std::string& nameOrPath);

/// How long an animation lasts, in seconds, which as in ModelOptions; 0 where the model has not got
/// it. Throws Error, as loadModel does.
[[nodiscard]] double animationSeconds(const std::string& nameOrPath, const std::string& animation);

}  // namespace tukor
