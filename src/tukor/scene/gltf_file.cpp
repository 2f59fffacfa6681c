#include "tukor/scene/gltf_file.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/materials/materials.h"
#include "tukor/scene/finish_mesh.h"
#include "tukor/scene/gltf_document.h"
#include "tukor/scene/gltf_features.h"
#include "tukor/scene/gltf_lights.h"
#include "tukor/scene/gltf_material.h"
#include "tukor/scene/gltf_nodes.h"
#include "tukor/scene/gltf_primitive.h"
#include "tukor/scene/gltf_variants.h"

namespace tukor {

namespace {

constexpr std::uint64_t kMostCopiedTriangles = 1 << 24;  // 600 MB of them
constexpr std::size_t kMostParts = 1 << 18;

// A small file can repeat what it has without end: that is found out before anything is read.
void checkTotal(const GltfDocument& document, const std::deque<GltfPlaced>& placed) {
    const JsonItem root = document.root();
    std::map<std::size_t, std::pair<std::uint64_t, std::size_t>> counts;  // triangles, primitives
    std::uint64_t triangles = 0;
    std::size_t parts = 0;
    // One-byte indices are the least that a triangle can take in the file.
    const std::uint64_t most =
        std::max<std::uint64_t>(kMostCopiedTriangles, document.largestBuffer() / 3);
    for (const GltfPlaced& one : placed) {
        auto known = counts.find(one.index);
        if (known == counts.end()) {
            std::pair<std::uint64_t, std::size_t> count{0, 0};
            for (const JsonItem primitive :
                 document.item("meshes", one.index, root).list("primitives")) {
                count.first += triangleCountOf(document, primitive);
                ++count.second;
                if (count.first > most) break;
            }
            known = counts.emplace(one.index, count).first;
        }
        triangles += known->second.first;
        parts += known->second.second;
        if (triangles > most || parts > kMostParts)
            throw Error(
                fmt::format("{}: its nodes repeat meshes to more than {} triangles or {} "
                            "parts",
                            document.name(), most, kMostParts));
    }
}

// A mesh's own triangles in the world.
Mesh placedMesh(Mesh mesh, const GltfPlaced& placed) {
    const glm::dmat3 linear(placed.worldFromNode);
    const glm::dvec3 origin(placed.worldFromNode[3]);
    // Normals follow the cross products of edges; a mirrored mesh has its winding turned back.
    const glm::dmat3 cofactors(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                               glm::cross(linear[0], linear[1]));
    const bool mirrored = glm::dot(linear[0], cofactors[0]) < 0.0;
    for (glm::vec3& p : mesh.positions) p = glm::vec3(linear * glm::dvec3(p) + origin);
    for (glm::vec3& n : mesh.normals) {
        const glm::dvec3 turned = cofactors * glm::dvec3(n) * (mirrored ? -1.0 : 1.0);
        const double length = glm::length(turned);  // tiny for millimetres: no floats yet
        n = length > 0.0 ? glm::vec3(turned / length) : glm::vec3(0.0f);
    }
    for (glm::vec4& t : mesh.tangents) t = glm::vec4(linear * glm::dvec3(t), mirrored ? -t.w : t.w);
    if (mirrored)
        for (glm::uvec3& t : mesh.triangles) std::swap(t.y, t.z);
    return mesh;
}

class Reader {
public:
    Reader(const GltfDocument& document, const ModelOptions& options)
        : document_(document), options_(options), textures_(document, notes_) {}

    Scene read() {
        noteFeatures(document_.root(), options_, notes_);
        const GltfPose pose = options_.timeSeconds
                                  ? poseAt(document_, options_.animation, *options_.timeSeconds)
                                  : GltfPose();
        const GltfPlacements placements = placementsOf(document_, pose);
        variant_ = variantOf(document_, options_.variant);
        checkTotal(document_, placements.meshes);
        for (const GltfPlaced& placed : placements.meshes)
            addMesh(placed, placements.worldFromNode);
        textures_.decode();
        if (scene_.parts.empty())
            throw Error(
                fmt::format("{}: nothing to render: no triangles in its scene", document_.name()));
        for (const GltfPlaced& placed : placements.cameras) addCamera(placed);
        for (const GltfPlaced& placed : placements.lights)
            scene_.lights.push_back(readGltfLight(document_, placed));
        scene_.warnings = notes_.sentences();
        return std::move(scene_);
    }

private:
    struct Look {
        std::string name;
        Material material;
    };
    enum class Tint { none, colors };  // of the vertices

    void addMesh(GltfPlaced placed, const std::vector<glm::dmat4>& worldFromNode) {
        const JsonItem mesh = document_.item("meshes", placed.index, document_.root());
        const std::string where = document_.item("nodes", placed.node, document_.root()).where();
        GltfDeformation deformation{std::move(placed.weights), {}};
        if (deformation.weights.empty())
            for (const JsonItem weight : mesh.list("weights"))
                deformation.weights.push_back(weight.number());
        if (placed.skin) {
            deformation.worldFromBind = jointsOf(
                document_, document_.item("skins", *placed.skin, document_.root()), worldFromNode);
            placed.worldFromNode = glm::dmat4(1.0);
        }
        for (const JsonItem primitive : mesh.list("primitives")) {
            Mesh triangles = readPrimitive(document_, primitive, deformation, placed.name, notes_);
            if (triangles.triangles.empty()) continue;
            triangles = finishedMesh(placedMesh(std::move(triangles), placed), options_.creaseAngle,
                                     where, placed.name, notes_);
            if (triangles.triangles.empty()) {
                notes_.add("scaled to nothing, left out", placed.name);
                continue;
            }
            const Look& look = lookOf(
                primitive, triangles.colors.empty() ? Tint::none : Tint::colors, placed.name);
            scene_.parts.push_back({placed.name, look.name, look.material, std::move(triangles)});
        }
    }

    const Look& lookOf(const JsonItem& primitive, Tint tint, const std::string& part) {
        const std::optional<JsonItem> index = materialOfVariant(primitive, variant_);
        const std::pair key(index ? index->count() : kNone, tint);
        auto known = looks_.find(key);
        if (known == looks_.end()) {
            Look look;
            if (index) {
                const JsonItem material = document_.item("materials", key.first, *index);
                const Surface surface = readGltfMaterial(
                    material, fmt::format("material {}", key.first), textures_, notes_);
                look = {surface.name, materialOf(surface)};
                if (tint == Tint::colors && !look.material.finish)
                    look.material.finish = std::make_shared<Finish>(surface);
            } else {
                look = withoutMaterial(tint, part);
            }
            known = looks_.emplace(key, std::move(look)).first;
        }
        return known->second;
    }

    /// Of primitives that name none, which glTF has white, metallic and rough: that is needed to
    /// show their colours; bare meshes are better shown as those of other formats are.
    Look withoutMaterial(Tint tint, const std::string& part) {
        if (tint == Tint::colors) {
            Surface white;
            white.solid = false;
            return {"", materialOf(white)};
        }
        if (document_.root().list("materials").size() > 0)
            notes_.add("without a material, shown as " + options_.material, part);
        return {"", parseMaterial(options_.material)};
    }

    void addCamera(const GltfPlaced& placed) {
        const JsonItem camera = document_.item("cameras", placed.index, document_.root());
        if (camera.at("type").text() != "perspective") {
            notes_.add("only perspective cameras are read", placed.name);
            return;
        }
        const double fov = camera.at("perspective").at("yfov").number();
        if (!(fov > 0.0 && fov < 3.14159)) camera.fail(fmt::format("a field of view of {}", fov));
        const glm::dvec3 back(placed.worldFromNode[2]), up(placed.worldFromNode[1]);
        if (!(glm::length(back) > 0.0 && glm::length(up) > 0.0)) {
            notes_.add("cameras scaled to nothing, left out", placed.name);
            return;
        }
        const Bounds bounds = boundsOf(scene_);
        NamedCamera named{placed.name, {}};
        named.camera.eye = glm::vec3(placed.worldFromNode[3]);
        const glm::vec3 forward = glm::vec3(-glm::normalize(back));
        // Viewers turn around the target: the middle of the scene where that is ahead.
        const float ahead = glm::dot(bounds.centre() - named.camera.eye, forward);
        const float least = std::max(1e-3f * bounds.radius(), 1e-6f);
        named.camera.target = named.camera.eye + std::max(ahead, least) * forward;
        named.camera.up = glm::vec3(glm::normalize(up));
        named.camera.verticalFov = static_cast<float>(fov);
        scene_.cameras.push_back(std::move(named));
    }

    static constexpr std::size_t kNone = ~std::size_t{0};

    const GltfDocument& document_;
    const ModelOptions& options_;
    Notes notes_;
    GltfTextures textures_;
    std::optional<std::size_t> variant_;
    Scene scene_;
    std::map<std::pair<std::size_t, Tint>, Look> looks_;  // by material; kNone: none given
};

}  // namespace

bool looksLikeGltf(std::span<const std::byte> bytes) noexcept {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (text.starts_with("glTF")) return true;
    const std::size_t start = text.substr(0, 4096).find_first_not_of("\xef\xbb\xbf \t\r\n");
    return start != std::string_view::npos && text[start] == '{';
}

Scene loadGltf(const std::filesystem::path& path, std::span<const std::byte> bytes,
               const ModelOptions& options) {
    const GltfDocument document(path, bytes);
    return Reader(document, options).read();
}

ModelChoices gltfChoices(const std::filesystem::path& path, std::span<const std::byte> bytes) {
    const GltfDocument document(path, bytes);
    ModelChoices choices;
    choices.variants = variantsOf(document);
    for (const JsonItem animation : document.root().list("animations"))
        choices.animations.emplace_back(animation.textOr("name", ""));
    return choices;
}

double gltfSeconds(const std::filesystem::path& path, std::span<const std::byte> bytes,
                   std::string_view animation) {
    return secondsOf(GltfDocument(path, bytes), animation);
}

}  // namespace tukor
