#include "tukor/scene/gltf_document.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/scene/gltf_features.h"
#include "tukor/scene/gltf_meshopt.h"
#include "tukor/scene/sibling_file.h"

namespace tukor {

namespace {

constexpr std::size_t kMostBuffers = 1000;                  // files open at once are limited
constexpr std::size_t kMostDecoded = std::size_t{1} << 30;  // views may share compressed bytes
constexpr std::uint32_t kGlbMagic = 0x46546c67, kJsonChunk = 0x4e4f534a, kBinaryChunk = 0x004e4942;

std::uint32_t word(std::span<const std::byte> bytes, std::size_t offset) noexcept {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes.data() + offset, sizeof value);  // little endian, as all hosts
    return value;
}

int base64Digit(char c) noexcept {
    if (c >= 'A' && c <= 'Z') return c - 'A';
    if (c >= 'a' && c <= 'z') return c - 'a' + 26;
    if (c >= '0' && c <= '9') return c - '0' + 52;
    if (c == '+' || c == '-') return 62;  // the second is of the alphabet for URLs
    if (c == '/' || c == '_') return 63;
    return -1;
}

std::vector<std::byte> base64Decoded(std::string_view text, const JsonItem& where) {
    while (text.ends_with('=')) text.remove_suffix(1);
    std::vector<std::byte> bytes;
    bytes.reserve(text.size() / 4 * 3 + 3);
    std::uint32_t bits = 0;
    int held = 0;
    for (const char c : text) {
        const int digit = base64Digit(c);
        if (digit < 0) where.fail("a data URI with a character that is not base64");
        bits = bits << 6 | static_cast<std::uint32_t>(digit);
        held += 6;
        if (held >= 8) {
            held -= 8;
            bytes.push_back(static_cast<std::byte>(bits >> held & 0xff));
        }
    }
    return bytes;
}

// Stands for what its compressed views decode to, in files for readers with the extension only.
bool isFallback(const JsonItem& buffer) {
    const std::optional<JsonItem> extensions = buffer.find("extensions");
    return extensions && extensions->find("EXT_meshopt_compression") && !buffer.find("uri");
}

}  // namespace

GltfDocument::GltfDocument(std::filesystem::path path, std::span<const std::byte> bytes)
    : path_(std::move(path)), name_(path_.string()) {
    readContainer(bytes);
    checkVersion();
    refuseUnknownExtensions(root());
    readBuffers();
    decodeViews();
}

void GltfDocument::readContainer(std::span<const std::byte> bytes) {
    if (bytes.size() < 4 || word(bytes, 0) != kGlbMagic) {
        json_ = parseJson(name_, bytes);
        return;
    }
    if (bytes.size() < 20)
        throw Error(
            fmt::format("{}: a GLB of {} bytes, cut off in its header", name_, bytes.size()));
    if (const std::uint32_t version = word(bytes, 4); version != 2)
        throw Error(fmt::format("{}: GLB version {}; expected 2", name_, version));
    if (const std::uint32_t length = word(bytes, 8); length > bytes.size())
        throw Error(fmt::format("{}: cut off: {} bytes of {}", name_, bytes.size(), length));
    bytes = bytes.first(word(bytes, 8));
    for (std::size_t offset = 12; offset + 8 <= bytes.size();) {
        const std::size_t length = word(bytes, offset);
        const std::uint32_t type = word(bytes, offset + 4);
        if (length > bytes.size() - offset - 8)
            throw Error(fmt::format("{}: a chunk of {} bytes where {} are left", name_, length,
                                    bytes.size() - offset - 8));
        const std::span<const std::byte> chunk = bytes.subspan(offset + 8, length);
        if (offset == 12 && type != kJsonChunk)
            throw Error(fmt::format("{}: a GLB whose first chunk is not JSON", name_));
        if (offset == 12) json_ = parseJson(name_, chunk);
        if (type == kBinaryChunk && chunk_.empty()) chunk_ = chunk;
        offset += 8 + (length + 3) / 4 * 4;
    }
    if (json_.kind(0) == JsonKind::null)
        throw Error(fmt::format("{}: a GLB without a JSON chunk", name_));
}

void GltfDocument::checkVersion() const {
    const JsonItem asset = root().at("asset");
    const std::string_view version = asset.at("version").text();
    if (!version.starts_with("2."))
        asset.fail(fmt::format("glTF version '{}'; expected 2.0", printable(version)));
    if (const std::string least = asset.textOr("minVersion", "2.0"); least != "2.0")
        asset.fail(fmt::format("needs glTF version '{}'; 2.0 is understood", printable(least)));
}

void GltfDocument::readBuffers() {
    const JsonList buffers = root().list("buffers");
    if (buffers.size() > kMostBuffers)
        root().fail(fmt::format("{} buffers; at most {} are read", buffers.size(), kMostBuffers));
    for (std::size_t i = 0; i < buffers.size(); ++i) {
        const std::size_t length = buffers[i].at("byteLength").count();
        if (isFallback(buffers[i])) {
            buffers_.emplace_back();
            continue;
        }
        const std::span<const std::byte> bytes = readBuffer(buffers[i], i);
        if (bytes.size() < length)
            buffers[i].fail(fmt::format("{} bytes; expected {}", bytes.size(), length));
        buffers_.push_back(bytes.first(length));
    }
}

std::span<const std::byte> GltfDocument::readBuffer(const JsonItem& buffer, std::size_t index) {
    const std::optional<JsonItem> uri = buffer.find("uri");
    if (!uri) {
        if (index > 0 || chunk_.empty()) buffer.fail("no uri, and no binary chunk to take it from");
        return chunk_;
    }
    loaded_.push_back(contents(*uri));
    return loaded_.back().bytes();
}

GltfBytes GltfDocument::contents(const JsonItem& uri) const {
    const std::string_view text = uri.text();
    GltfBytes contents;
    if (text.starts_with("data:")) {
        const std::size_t comma = text.find(',');
        if (comma == std::string_view::npos || !text.substr(0, comma).ends_with(";base64"))
            uri.fail("a data URI that is not base64");
        contents.decoded = base64Decoded(text.substr(comma + 1), uri);
        return contents;
    }
    const std::filesystem::path file = siblingPath(path_, text);
    try {
        contents.file.emplace(file);
    } catch (const Error& error) {
        throw Error(fmt::format("{}: needs {}", name_, error.what()));
    }
    return contents;
}

std::size_t GltfDocument::largestBuffer() const noexcept {
    std::size_t largest = 0;
    for (const std::span<const std::byte> buffer : buffers_)
        largest = std::max(largest, buffer.size());
    return largest;
}

JsonItem GltfDocument::item(const char* array, std::size_t index, const JsonItem& user) const {
    const std::optional<JsonItem> items = root().find(array);
    const std::size_t count = items ? items->size() : 0;
    if (index >= count)
        user.fail(fmt::format("refers to {}[{}]; there are {}", array, index, count));
    return (*items)[index];
}

JsonItem GltfDocument::referred(const char* array, const JsonItem& user, const char* member) const {
    return item(array, user.at(member).count(), user);
}

std::span<const std::byte> GltfDocument::range(const JsonItem& user) const {
    const std::size_t buffer = user.at("buffer").count();
    const std::size_t offset = user.countOr("byteOffset", 0);
    const std::size_t length = user.at("byteLength").count();
    if (buffer >= buffers_.size())
        user.fail(fmt::format("refers to buffers[{}]; there are {}", buffer, buffers_.size()));
    const std::size_t size = buffers_[buffer].size();
    if (offset > size || length > size - offset)
        user.fail(fmt::format("bytes {} to {} of a buffer of {}", offset, offset + length, size));
    return buffers_[buffer].subspan(offset, length);
}

void GltfDocument::decodeViews() {
    std::size_t total = 0, index = 0;
    for (const JsonItem view : root().list("bufferViews")) {
        const std::size_t number = index++;
        const std::optional<JsonItem> extensions = view.find("extensions");
        if (!extensions) continue;
        const std::optional<JsonItem> extension = extensions->find("EXT_meshopt_compression");
        if (!extension) continue;
        std::vector<std::byte> bytes = meshoptDecoded(*extension, range(*extension));
        if (bytes.size() < view.at("byteLength").count())
            extension->fail(fmt::format("{} bytes for a view of {}", bytes.size(),
                                        view.at("byteLength").count()));
        total += bytes.size();
        if (total > kMostDecoded)
            extension->fail(
                fmt::format("more than {} bytes come out of the compressed views", kMostDecoded));
        views_.emplace(number, std::move(bytes));
    }
}

GltfView GltfDocument::view(std::size_t index, const JsonItem& user) const {
    const JsonItem view = item("bufferViews", index, user);
    const std::size_t stride = view.countOr("byteStride", 0);
    if (stride > 252)  // the specification's limit
        view.fail(fmt::format("a stride of {} bytes; at most 252 are allowed", stride));
    const auto decoded = views_.find(index);
    if (decoded != views_.end()) return {decoded->second, stride};
    return {range(view), stride};
}

}  // namespace tukor
