#include "tukor/scene/single_part.h"

#include <utility>

#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/materials/materials.h"
#include "tukor/scene/finish_mesh.h"

namespace tukor {

Scene singlePart(const std::filesystem::path& path, Mesh mesh, const ModelOptions& options) {
    Notes notes;
    Scene scene;
    mesh = finishedMesh(std::move(mesh), options.creaseAngle, path.string(), "", notes);
    if (mesh.triangles.empty())
        throw Error(fmt::format("{}: nothing to render: no triangles", path.string()));
    scene.parts.push_back(
        {path.stem().string(), "", parseMaterial(options.material), std::move(mesh)});
    scene.warnings = notes.sentences();
    return scene;
}

}  // namespace tukor
