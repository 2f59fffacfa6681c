#include "tukor/scene/assimp_file.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <exception>
#include <iterator>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <assimp/IOStream.hpp>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/base/file.h"
#include "tukor/materials/materials.h"
#include "tukor/scene/finish_mesh.h"
#include "tukor/scene/sibling_file.h"
#include "tukor/scene/surface.h"

namespace tukor {

namespace {

// Readers of this many formats were not written with hostile files in mind: large ones are refused.
constexpr std::size_t kMostBytes = 1u << 29;
// Those that people exchange models in. Readers that allocate what a header promises (OFF among
// them) are left out.
constexpr std::string_view kExtensions[] = {".fbx", ".dae",   ".3ds", ".3mf",  ".x",
                                            ".lwo", ".blend", ".ac",  ".ms3d", ".x3d"};
constexpr std::size_t kMostNodes = 1 << 18;

// A view of memory; of a file that is mapped for it, or of the model itself.
class MemoryStream final : public Assimp::IOStream {
public:
    explicit MemoryStream(std::span<const std::byte> bytes) : bytes_(bytes) {}
    explicit MemoryStream(MappedFile file) : file_(std::move(file)), bytes_(file_->bytes()) {}

    std::size_t Read(void* to, std::size_t size, std::size_t count) override {
        if (size == 0) return 0;
        const std::size_t whole = std::min(count, (bytes_.size() - at_) / size);
        std::memcpy(to, bytes_.data() + at_, whole * size);
        at_ += whole * size;
        return whole;
    }
    std::size_t Write(const void*, std::size_t, std::size_t) override { return 0; }
    aiReturn Seek(std::size_t offset, aiOrigin origin) override {
        const std::size_t from = origin == aiOrigin_SET   ? 0
                                 : origin == aiOrigin_CUR ? at_
                                                          : bytes_.size();
        const std::size_t to = from + offset;  // negative offsets wrap, as they should
        if (to > bytes_.size()) return aiReturn_FAILURE;
        at_ = to;
        return aiReturn_SUCCESS;
    }
    std::size_t Tell() const override { return at_; }
    std::size_t FileSize() const override { return bytes_.size(); }
    void Flush() override {}

private:
    std::optional<MappedFile> file_;
    std::span<const std::byte> bytes_;
    std::size_t at_ = 0;
};

// Shows Assimp the model as `model.EXT`, and besides it only files below the model's folder.
class Folder final : public Assimp::IOSystem {
public:
    Folder(const std::filesystem::path& model, std::span<const std::byte> bytes)
        : model_(model), name_("model" + lowerExtension(model)), bytes_(bytes) {}

    [[nodiscard]] const std::string& name() const noexcept { return name_; }

    bool Exists(const char* file) const override {
        if (file == name_) return true;
        try {
            return std::filesystem::is_regular_file(siblingPath(model_, withoutDot(file)));
        } catch (const std::exception&) {
            return false;
        }
    }
    char getOsSeparator() const override { return '/'; }
    Assimp::IOStream* Open(const char* file, const char* mode) override {
        if (mode == nullptr || std::strpbrk(mode, "wa+") != nullptr) return nullptr;
        if (file == name_) return new MemoryStream(bytes_);
        try {
            return new MemoryStream(MappedFile(siblingPath(model_, withoutDot(file)), kMostBytes));
        } catch (const std::exception&) {  // Assimp asks for what may not be there
            return nullptr;
        }
    }
    void Close(Assimp::IOStream* stream) override { delete stream; }

private:
    static std::string_view withoutDot(std::string_view file) {
        while (file.starts_with("./")) file.remove_prefix(2);
        return file;
    }

    const std::filesystem::path& model_;
    std::string name_;
    std::span<const std::byte> bytes_;
};

glm::dmat4 matrixOf(const aiMatrix4x4& m) noexcept {
    return glm::transpose(glm::dmat4(m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2,
                                     m.c3, m.c4, m.d1, m.d2, m.d3, m.d4));
}

Surface surfaceOf(const aiMaterial& material) {
    Surface surface;
    surface.name = material.GetName().C_Str();
    surface.metallic = 0.0f;
    aiColor3D colour(1.0f, 1.0f, 1.0f);
    if (material.Get(AI_MATKEY_BASE_COLOR, colour) == AI_SUCCESS ||
        material.Get(AI_MATKEY_COLOR_DIFFUSE, colour) == AI_SUCCESS)
        surface.baseColor = {colour.r, colour.g, colour.b};
    (void)material.Get(AI_MATKEY_METALLIC_FACTOR, surface.metallic);
    (void)material.Get(AI_MATKEY_ROUGHNESS_FACTOR, surface.roughness);
    (void)material.Get(AI_MATKEY_TRANSMISSION_FACTOR, surface.transmission);
    float ior = 0.0f, opacity = 1.0f;
    if (material.Get(AI_MATKEY_REFRACTI, ior) == AI_SUCCESS && ior > 1.0f) surface.ior = ior;
    if (material.Get(AI_MATKEY_OPACITY, opacity) == AI_SUCCESS && opacity < 0.5f) {
        surface.transmission = 1.0f;
        surface.roughness = 0.0f;
        surface.baseColor = glm::vec3(1.0f);
    }
    return surface;
}

class Converter {
public:
    Converter(const std::filesystem::path& path, const aiScene& source, const ModelOptions& options)
        : name_(path.string()), source_(source), options_(options) {}

    Scene convert() {
        struct Pending {
            const aiNode* node;
            glm::dmat4 worldFromParent;
        };
        std::vector<Pending> pending{{source_.mRootNode, glm::dmat4(1.0)}};
        std::size_t nodes = 0;
        while (!pending.empty()) {
            const Pending next = pending.back();
            pending.pop_back();
            if (++nodes > kMostNodes)
                throw Error(fmt::format("{}: more than {} nodes", name_, kMostNodes));
            const glm::dmat4 world = next.worldFromParent * matrixOf(next.node->mTransformation);
            for (unsigned i = 0; i < next.node->mNumMeshes; ++i)
                addMesh(*next.node, *source_.mMeshes[next.node->mMeshes[i]], world);
            for (unsigned i = next.node->mNumChildren; i-- > 0;)
                pending.push_back({next.node->mChildren[i], world});
        }
        if (source_.HasAnimations()) notes_.add("animations are not rendered");
        if (scene_.parts.empty())
            throw Error(fmt::format("{}: nothing to render: no triangles", name_));
        scene_.warnings = notes_.sentences();
        return std::move(scene_);
    }

private:
    void addMesh(const aiNode& node, const aiMesh& source, const glm::dmat4& world) {
        const std::string name = node.mName.length > 0 ? node.mName.C_Str() : source.mName.C_Str();
        if (source.HasBones()) notes_.add("skins are not rendered; shapes stay as modelled", name);
        Mesh mesh;
        const bool mirrored = glm::determinant(glm::dmat3(world)) < 0.0;
        const glm::dmat3 linear(world);
        const glm::dmat3 cofactors(glm::cross(linear[1], linear[2]),
                                   glm::cross(linear[2], linear[0]),
                                   glm::cross(linear[0], linear[1]));
        for (unsigned i = 0; i < source.mNumVertices; ++i) {
            const aiVector3D& p = source.mVertices[i];
            mesh.positions.emplace_back(world * glm::dvec4(p.x, p.y, p.z, 1.0));
            if (!source.HasNormals()) continue;
            const aiVector3D& n = source.mNormals[i];
            const glm::dvec3 turned =
                cofactors * glm::dvec3(n.x, n.y, n.z) * (mirrored ? -1.0 : 1.0);
            const double length = glm::length(turned);
            mesh.normals.emplace_back(length > 0.0 ? turned / length : glm::dvec3(0.0));
        }
        for (unsigned i = 0; i < source.mNumFaces; ++i) {
            const aiFace& face = source.mFaces[i];
            if (face.mNumIndices != 3) continue;  // points and lines
            const unsigned* const t = face.mIndices;
            mesh.triangles.emplace_back(t[0], t[mirrored ? 2 : 1], t[mirrored ? 1 : 2]);
        }
        mesh = finishedMesh(std::move(mesh), options_.creaseAngle, name_, name, notes_);
        if (mesh.triangles.empty()) return;
        Part part{name, "", parseMaterial(options_.material), std::move(mesh)};
        if (source.mMaterialIndex < source_.mNumMaterials) {
            const Surface surface = surfaceOf(*source_.mMaterials[source.mMaterialIndex]);
            if (!surface.name.empty() && surface.name != AI_DEFAULT_MATERIAL_NAME) {
                part.materialName = surface.name;
                part.material = materialOf(surface);
            }
        }
        scene_.parts.push_back(std::move(part));
    }

    std::string name_;
    const aiScene& source_;
    const ModelOptions& options_;
    Notes notes_;
    Scene scene_;
};

}  // namespace

bool assimpReads(const std::string& extension) {
    return std::find(std::begin(kExtensions), std::end(kExtensions), extension) !=
           std::end(kExtensions);
}

Scene loadThroughAssimp(const std::filesystem::path& path, std::span<const std::byte> bytes,
                        const ModelOptions& options) {
    if (bytes.size() > kMostBytes)
        throw Error(fmt::format("{}: {} bytes; models of this format are read up to {} bytes",
                                path.string(), bytes.size(), kMostBytes));
    try {
        Assimp::Importer importer;
        auto* const folder = new Folder(path, bytes);  // the importer deletes it
        importer.SetIOHandler(folder);
        const aiScene* const scene = importer.ReadFile(
            folder->name(), aiProcess_Triangulate | aiProcess_ValidateDataStructure);
        if (scene == nullptr || scene->mRootNode == nullptr)
            throw Error(fmt::format("{}: cannot be read: {}", path.string(),
                                    printable(importer.GetErrorString())));
        return Converter(path, *scene, options).convert();
    } catch (const Error&) {
        throw;
    } catch (const std::exception& error) {
        throw Error(fmt::format("{}: cannot be read: {}", path.string(), printable(error.what())));
    }
}

}  // namespace tukor
