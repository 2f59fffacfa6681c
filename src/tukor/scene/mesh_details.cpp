#include "tukor/scene/mesh_details.h"

#include <utility>

#include "tukor/scene/interner.h"

namespace tukor {

bool hasDetails(const Mesh& mesh) noexcept {
    return !mesh.uvs[0].empty() || !mesh.uvs[1].empty() || !mesh.tangents.empty() ||
           !mesh.colors.empty();
}

Mesh withDetailsOf(const Mesh& source, const std::vector<glm::uvec3>& sources, Mesh target) {
    Interner<IndexPair> pairs(target.positions.size());  // of target and source vertex
    for (std::size_t i = 0; i < target.triangles.size(); ++i)
        for (int c = 0; c < 3; ++c)
            target.triangles[i][c] = pairs.add({target.triangles[i][c], sources[i][c]});
    const std::vector<IndexPair> made = std::move(pairs).take();
    Mesh result;
    result.triangles = std::move(target.triangles);
    const auto gather = [&](const auto& from, auto& to, int which) {
        if (from.empty()) return;
        to.reserve(made.size());
        for (const IndexPair pair : made) to.push_back(from[which == 0 ? pair.first : pair.second]);
    };
    gather(target.positions, result.positions, 0);
    gather(target.normals, result.normals, 0);
    for (std::size_t set = 0; set < result.uvs.size(); ++set)
        gather(source.uvs[set], result.uvs[set], 1);
    gather(source.tangents, result.tangents, 1);
    gather(source.colors, result.colors, 1);
    return result;
}

}  // namespace tukor
