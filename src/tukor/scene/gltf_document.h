// The container of glTF 2.0: JSON or GLB, its buffers from wherever they come, and views of them.
#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tukor/base/file.h"
#include "tukor/scene/json_item.h"

namespace tukor {

/// Bytes of a buffer view. `stride` is 0 where elements follow each other closely.
struct GltfView {
    std::span<const std::byte> bytes;
    std::size_t stride = 0;
};

/// What a URI refers to: decoded from itself, or a file.
struct GltfBytes {
    std::vector<std::byte> decoded;
    std::optional<MappedFile> file;

    [[nodiscard]] std::span<const std::byte> bytes() const noexcept {
        return file ? file->bytes() : std::span<const std::byte>(decoded);
    }
};

/// A parsed glTF file with all of its buffers at hand. Other files are only read below its folder.
class GltfDocument {
public:
    /// `bytes` are the file's, and must outlive the document. Throws Error where the container, the
    /// version, a required extension or a buffer is not what it should be.
    GltfDocument(std::filesystem::path path, std::span<const std::byte> bytes);

    GltfDocument(const GltfDocument&) = delete;  // items and views refer to it
    GltfDocument& operator=(const GltfDocument&) = delete;

    [[nodiscard]] JsonItem root() const { return {json_, name_}; }
    [[nodiscard]] const std::string& name() const noexcept { return name_; }
    /// Of the largest buffer: what the file can really hold.
    [[nodiscard]] std::size_t largestBuffer() const noexcept;

    /// Item `index` of a top-level array such as `meshes`; `user` is who refers to it.
    [[nodiscard]] JsonItem item(const char* array, std::size_t index, const JsonItem& user) const;
    /// The same for an index given by a member of `user` that must be there.
    [[nodiscard]] JsonItem referred(const char* array, const JsonItem& user,
                                    const char* member) const;
    /// The contents of a data URI or of a file below the model's folder. Throws Error.
    [[nodiscard]] GltfBytes contents(const JsonItem& uri) const;
    /// A buffer view inside its buffer.
    [[nodiscard]] GltfView view(std::size_t index, const JsonItem& user) const;

private:
    void readContainer(std::span<const std::byte> bytes);
    void checkVersion() const;
    void readBuffers();
    void decodeViews();
    [[nodiscard]] std::span<const std::byte> range(const JsonItem& user) const;
    std::span<const std::byte> readBuffer(const JsonItem& buffer, std::size_t index);

    std::filesystem::path path_;
    std::string name_;
    JsonDocument json_;
    std::span<const std::byte> chunk_;  // the binary one of a GLB
    std::vector<std::span<const std::byte>> buffers_;
    std::vector<GltfBytes> loaded_;                        // those from URIs
    std::map<std::size_t, std::vector<std::byte>> views_;  // those that were compressed
};

}  // namespace tukor
