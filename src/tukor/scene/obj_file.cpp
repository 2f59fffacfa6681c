#include "tukor/scene/obj_file.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/base/file.h"
#include "tukor/materials/materials.h"
#include "tukor/scene/finish_mesh.h"
#include "tukor/scene/interner.h"
#include "tukor/scene/mtl_file.h"
#include "tukor/scene/polygon.h"
#include "tukor/scene/sibling_file.h"
#include "tukor/scene/text_scanner.h"

namespace tukor {

namespace {

constexpr unsigned kNone = ~0u;  // of normals, of texture coordinates
constexpr std::size_t kMostParts = 1 << 18;

class ObjReader {
public:
    ObjReader(const std::filesystem::path& path, std::span<const std::byte> bytes,
              const ModelOptions& options)
        : path_(path), scanner_(bytes), options_(options), textures_(path, notes_) {
        positions_.reserve(bytes.size() / 128);  // a vertex, its normal and two triangles
        normals_.reserve(bytes.size() / 128);
    }

    Scene read() {
        for (; !scanner_.atEnd(); scanner_.skipLine()) readLine(scanner_.word());
        Scene scene;
        for (Piece& piece : pieces_) finish(std::move(piece), scene);
        textures_.decode();
        if (scene.parts.empty())
            throw Error(fmt::format("{}: nothing to render: no faces", path_.string()));
        scene.warnings = notes_.sentences();
        return scene;
    }

private:
    // The faces of one object or group that have one material.
    struct Piece {
        std::string name, material;
        Interner<IndexPair> corners;  // position, normal
        Interner<IndexPair> placed;   // corner, texture coordinates; empty where none are wanted
        std::vector<glm::uvec3> triangles;
        bool hasNormals = true;
        bool textured = false;
    };
    // Of a face.
    struct Corner {
        IndexPair ends;  // position, normal
        unsigned uv;
    };

    [[noreturn]] void fail(std::string_view message) const {
        throw Error(fmt::format("{}: line {}: {}", path_.string(), scanner_.line(), message));
    }

    void readLine(std::string_view key) {
        if (key == "v") {
            positions_.push_back(readVector());
        } else if (key == "vn") {
            normals_.push_back(readVector());
        } else if (key == "vt") {
            readUv();
        } else if (key == "f") {
            readFace();
        } else if (key == "o" || key == "g") {
            group_ = scanner_.restOfLine();
            piece_ = nullptr;
        } else if (key == "usemtl") {
            material_ = scanner_.restOfLine();
            piece_ = nullptr;
        } else if (key == "mtllib") {
            readLibrary(scanner_.restOfLine());
        } else if (key == "l" || key == "p" || key == "curv" || key == "surf") {
            notes_.add("lines, points and free-form surfaces are not rendered", group_);
        }
    }

    glm::vec3 readVector() {
        glm::vec3 value;
        for (int i = 0; i < 3; ++i) {
            const std::string_view word = scanner_.word();
            const std::optional<float> number = floatOf(word);
            if (!number) fail(fmt::format("'{}' where a number was expected", printable(word)));
            value[i] = *number;
        }
        return value;
    }

    void readUv() {
        const std::string_view u = scanner_.word(), v = scanner_.word();
        const std::optional<float> x = floatOf(u), y = v.empty() ? 0.0f : floatOf(v);
        if (!x || !y) fail(fmt::format("'{}' where a number was expected", printable(x ? v : u)));
        uvs_.emplace_back(*x, 1.0f - *y);
    }

    // From 1 up, or from -1 down from the last one read.
    unsigned indexOf(std::string_view word, std::size_t count) const {
        const std::optional<std::int64_t> given = integerOf(word);
        if (!given) fail(fmt::format("'{}' where an index was expected", printable(word)));
        const auto size = static_cast<std::int64_t>(count);
        const std::int64_t index = *given > 0 ? *given - 1 : size + *given;
        if (*given == 0 || index < 0 || index >= size)
            fail(fmt::format("index {} of {}", *given, size));
        return static_cast<unsigned>(index);
    }

    Corner cornerOf(std::string_view word, bool textured) const {
        const std::size_t slash = word.find('/');
        Corner corner{{indexOf(word.substr(0, slash), positions_.size()), kNone}, kNone};
        if (slash == std::string_view::npos) return corner;
        const std::size_t second = word.find('/', slash + 1);
        const std::string_view uv = word.substr(slash + 1, second - slash - 1);
        if (textured && !uv.empty()) corner.uv = indexOf(uv, uvs_.size());
        if (second != std::string_view::npos && second + 1 < word.size())
            corner.ends.second = indexOf(word.substr(second + 1), normals_.size());
        return corner;
    }

    void readFace() {
        Piece& piece = currentPiece();
        face_.clear();
        for (std::string_view word = scanner_.word(); !word.empty(); word = scanner_.word()) {
            const Corner corner = cornerOf(word, piece.textured);
            piece.hasNormals &= corner.ends.second != kNone;
            face_.push_back(corner);
        }
        if (face_.size() < 3) fail(fmt::format("a face of {} corners", face_.size()));
        numbers_.clear();
        for (const Corner& corner : face_) {
            const unsigned number = piece.corners.add(corner.ends);
            numbers_.push_back(piece.textured ? piece.placed.add({number, corner.uv}) : number);
        }
        if (face_.size() == 3) {
            piece.triangles.emplace_back(numbers_[0], numbers_[1], numbers_[2]);
            return;
        }
        outline_.clear();
        for (const Corner& corner : face_) outline_.push_back(positions_[corner.ends.first]);
        cut_.clear();
        triangulate(outline_, cut_);
        for (const glm::uvec3 t : cut_)
            piece.triangles.emplace_back(numbers_[t.x], numbers_[t.y], numbers_[t.z]);
    }

    Piece& currentPiece() {
        if (piece_ != nullptr) return *piece_;
        const auto [known, isNew] =
            index_.try_emplace({std::string(group_), std::string(material_)}, pieces_.size());
        if (isNew) {
            if (pieces_.size() == kMostParts) fail(fmt::format("more than {} groups", kMostParts));
            Piece& piece = pieces_.emplace_back();
            piece.name = group_;
            piece.material = material_;
            piece.textured = isTextured(piece.material);
        }
        piece_ = &pieces_[known->second];
        return *piece_;
    }

    bool isTextured(const std::string& material) const {
        const auto surface = surfaces_.find(material);
        return surface != surfaces_.end() && hasTextures(surface->second);
    }

    void readLibrary(std::string_view name) {
        try {
            const MappedFile file(siblingPath(path_, name));
            surfaces_.merge(readMtl(file.bytes(), textures_, notes_));
        } catch (const Error& error) {  // shapes can be rendered without
            notes_.add("a material library cannot be read", error.what());
        }
    }

    void finish(Piece piece, Scene& scene) {
        Mesh mesh;
        const std::vector<IndexPair>& corners = piece.corners.keys();
        const auto add = [&](const IndexPair& corner) {
            mesh.positions.push_back(positions_[corner.first]);
            if (piece.hasNormals) mesh.normals.push_back(normals_[corner.second]);
        };
        const std::size_t count = std::max(corners.size(), piece.placed.keys().size());
        mesh.positions.reserve(count);
        if (piece.hasNormals) mesh.normals.reserve(count);
        if (piece.textured) {
            for (const IndexPair& place : piece.placed.keys()) {
                add(corners[place.first]);
                mesh.uvs[0].push_back(place.second == kNone ? glm::vec2(0.0f) : uvs_[place.second]);
            }
        } else {
            for (const IndexPair& corner : corners) add(corner);
        }
        mesh.triangles = std::move(piece.triangles);
        mesh =
            finishedMesh(std::move(mesh), options_.creaseAngle, path_.string(), piece.name, notes_);
        if (mesh.triangles.empty()) return;
        const auto surface = surfaces_.find(piece.material);
        const Material material = surface == surfaces_.end() ? parseMaterial(options_.material)
                                                             : materialOf(surface->second);
        scene.parts.push_back({piece.name, piece.material, material, std::move(mesh)});
    }

    const std::filesystem::path& path_;
    TextScanner scanner_;
    const ModelOptions& options_;
    std::vector<glm::vec3> positions_, normals_;
    std::vector<glm::vec2> uvs_;  // v runs down
    std::string_view group_, material_;
    Piece* piece_ = nullptr;  // of group_ and material_, once a face has asked for it
    std::vector<Piece> pieces_;
    std::map<std::pair<std::string, std::string>, std::size_t> index_;
    std::map<std::string, Surface> surfaces_;
    Notes notes_;
    FileTextures textures_;
    std::vector<Corner> face_;  // scratch space of readFace()
    std::vector<unsigned> numbers_;
    std::vector<glm::vec3> outline_;
    std::vector<glm::uvec3> cut_;
};

}  // namespace

Scene loadObj(const std::filesystem::path& path, std::span<const std::byte> bytes,
              const ModelOptions& options) {
    return ObjReader(path, bytes, options).read();
}

}  // namespace tukor
