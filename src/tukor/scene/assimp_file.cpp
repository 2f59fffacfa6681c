#include "tukor/scene/assimp_file.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <exception>
#include <initializer_list>
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
#include "tukor/scene/file_textures.h"
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

// Of FBX, whose unit is a centimetre unless it says another.
double metresPerUnit(const aiScene& scene) {
    double centimetres = 0.0;
    float single = 0.0f;
    if (scene.mMetaData == nullptr) return 1.0;
    if (scene.mMetaData->Get("UnitScaleFactor", single))
        centimetres = static_cast<double>(single);
    else if (!scene.mMetaData->Get("UnitScaleFactor", centimetres))
        return 1.0;
    return centimetres > 0.0 && std::isfinite(centimetres) ? 0.01 * centimetres : 1.0;
}

TextureMap mapOf(const aiMaterial& material, aiTextureType type, unsigned uvSet) {
    TextureMap map;
    map.uvSet = static_cast<int>(uvSet);
    aiUVTransform t;
    if (material.Get(AI_MATKEY_UVTRANSFORM(type, 0), t) == AI_SUCCESS)
        map.imageFromUv =
            imageFromUpwardUv({t.mScaling.x, t.mScaling.y}, {t.mTranslation.x, t.mTranslation.y});
    const auto wrap = [](int mode) {
        return mode == aiTextureMapMode_Clamp    ? Wrap::clamp
               : mode == aiTextureMapMode_Mirror ? Wrap::mirror
                                                 : Wrap::repeat;
    };
    int modeU = aiTextureMapMode_Wrap, modeV = aiTextureMapMode_Wrap;
    (void)material.Get(AI_MATKEY_MAPPINGMODE_U(type, 0), modeU);
    (void)material.Get(AI_MATKEY_MAPPINGMODE_V(type, 0), modeV);
    map.wrapU = wrap(modeU);
    map.wrapV = wrap(modeV);
    return map;
}

/// The textures of one material.
class MaterialTextures {
public:
    MaterialTextures(const aiScene& scene, const aiMaterial& material, FileTextures& textures,
                     Notes& notes)
        : scene_(scene), material_(material), textures_(textures), notes_(notes) {}

    /// The first of these that there is; without texels where there is none.
    [[nodiscard]] TextureMap first(std::initializer_list<aiTextureType> types) {
        for (const aiTextureType type : types) {
            aiString file;
            unsigned uvSet = 0;
            if (material_.GetTexture(type, 0, &file, nullptr, &uvSet) != AI_SUCCESS) continue;
            if (uvSet > 1) {
                notes_.add("textures on a third set of coordinates are not rendered",
                           material_.GetName().C_Str());
                continue;
            }
            TextureMap map = mapOf(material_, type, uvSet);
            map.texels = picture(file);
            if (map.texels) return map;
        }
        return {};
    }

private:
    FileTextures::Picture picture(const aiString& name) {
        const aiTexture* const inside = scene_.GetEmbeddedTexture(name.C_Str());
        if (inside == nullptr) return textures_.file(name.C_Str());
        if (inside->mHeight > 0) {
            notes_.add("textures that are not compressed, left out", printable(name.C_Str()));
            return nullptr;
        }
        return textures_.encoded(
            name.C_Str(), std::as_bytes(std::span(reinterpret_cast<const char*>(inside->pcData),
                                                  inside->mWidth)));
    }

    const aiScene& scene_;
    const aiMaterial& material_;
    FileTextures& textures_;
    Notes& notes_;
};

void addTextures(MaterialTextures& found, Surface& surface, FileTextures& textures) {
    const auto give = [&](TextureRole role, TextureMap map, FileTextures::Picture texels) {
        map.texels = std::move(texels);
        surface.maps[static_cast<std::size_t>(role)] = std::move(map);
    };
    const TextureMap colour = found.first({aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE});
    if (colour.texels) countTextureAlone(surface.baseColor);
    give(TextureRole::baseColor, colour, colour.texels);

    const TextureMap light = found.first({aiTextureType_EMISSION_COLOR, aiTextureType_EMISSIVE});
    if (light.texels) countTextureAlone(surface.emission);
    give(TextureRole::emission, light, light.texels);

    const TextureMap metallic = found.first({aiTextureType_METALNESS});
    const TextureMap roughness = found.first({aiTextureType_DIFFUSE_ROUGHNESS});
    if (metallic.texels) countTextureAlone(surface.metallic);
    give(TextureRole::metallicRoughness, metallic.texels ? metallic : roughness,
         textures.metallicRoughness(metallic.texels, roughness.texels));

    const TextureMap relief =
        found.first({aiTextureType_NORMALS, aiTextureType_NORMAL_CAMERA, aiTextureType_HEIGHT});
    give(TextureRole::normal, relief, textures.normals(relief.texels, 1.0f));
}

Surface surfaceOf(const aiMaterial& material, MaterialTextures found, FileTextures& textures) {
    Surface surface;
    surface.name = material.GetName().C_Str();
    surface.metallic = 0.0f;
    const auto colour = [&](const char* key, unsigned type, unsigned index, glm::vec3& value) {
        aiColor3D c;
        if (material.Get(key, type, index, c) != AI_SUCCESS) return false;
        value = glm::max(glm::vec3(c.r, c.g, c.b), 0.0f);
        return true;
    };
    if (!colour(AI_MATKEY_BASE_COLOR, surface.baseColor))
        (void)colour(AI_MATKEY_COLOR_DIFFUSE, surface.baseColor);
    (void)colour(AI_MATKEY_COLOR_EMISSIVE, surface.emission);
    (void)material.Get(AI_MATKEY_METALLIC_FACTOR, surface.metallic);
    float exponent = 0.0f;
    if (material.Get(AI_MATKEY_ROUGHNESS_FACTOR, surface.roughness) != AI_SUCCESS &&
        material.Get(AI_MATKEY_SHININESS, exponent) == AI_SUCCESS && exponent > 0.0f)
        surface.roughness = roughnessFromExponent(exponent);
    (void)material.Get(AI_MATKEY_TRANSMISSION_FACTOR, surface.transmission);
    float ior = 0.0f, opacity = 1.0f;
    if (material.Get(AI_MATKEY_REFRACTI, ior) == AI_SUCCESS && ior > 1.0f) surface.ior = ior;
    (void)material.Get(AI_MATKEY_OPACITY, opacity);
    if (opacity < kGlassBelow) {
        surface.transmission = 1.0f;
        surface.roughness = 0.0f;
        surface.baseColor = glm::vec3(1.0f);
        return surface;
    }
    setOpacity(surface, opacity);
    addTextures(found, surface, textures);
    return surface;
}

class Converter {
public:
    Converter(const std::filesystem::path& path, const aiScene& source, const ModelOptions& options)
        : name_(path.string()), source_(source), options_(options), textures_(path, notes_) {
        for (unsigned i = 0; i < source.mNumMaterials; ++i) {
            const aiMaterial& material = *source.mMaterials[i];
            surfaces_.push_back(surfaceOf(
                material, MaterialTextures(source, material, textures_, notes_), textures_));
        }
    }

    Scene convert() {
        struct Pending {
            const aiNode* node;
            glm::dmat4 worldFromParent;
        };
        std::vector<Pending> pending{
            {source_.mRootNode, glm::dmat4(glm::dmat3(metresPerUnit(source_)))}};
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
        textures_.decode();
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
            for (unsigned set = 0; set < mesh.uvs.size(); ++set)
                if (source.HasTextureCoords(set)) {
                    const aiVector3D& uv = source.mTextureCoords[set][i];
                    mesh.uvs[set].emplace_back(uv.x, 1.0f - uv.y);
                }
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
            const Surface& surface = surfaces_[source.mMaterialIndex];
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
    FileTextures textures_;
    std::vector<Surface> surfaces_;  // by material
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
