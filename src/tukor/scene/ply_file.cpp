#include "tukor/scene/ply_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/scene/ply_header.h"
#include "tukor/scene/polygon.h"
#include "tukor/scene/sibling_file.h"
#include "tukor/scene/single_part.h"
#include "tukor/scene/text_scanner.h"

namespace tukor {

namespace {

template <class T>
double loadAs(const std::byte* from) noexcept {
    T value;
    std::memcpy(&value, from, sizeof value);
    return static_cast<double>(value);
}

double load(const std::byte* from, PlyType type) noexcept {
    switch (type) {
        case PlyType::int8:
            return loadAs<std::int8_t>(from);
        case PlyType::uint8:
            return loadAs<std::uint8_t>(from);
        case PlyType::int16:
            return loadAs<std::int16_t>(from);
        case PlyType::uint16:
            return loadAs<std::uint16_t>(from);
        case PlyType::int32:
            return loadAs<std::int32_t>(from);
        case PlyType::uint32:
            return loadAs<std::uint32_t>(from);
        case PlyType::float32:
            return loadAs<float>(from);
        case PlyType::float64:
            break;
    }
    return loadAs<double>(from);
}

class PlyReader {
public:
    PlyReader(const std::filesystem::path& path, std::span<const std::byte> bytes)
        : name_(path.string()),
          header_(readPlyHeader(name_, bytes)),
          left_(bytes.subspan(header_.size)),
          scanner_(left_) {}

    Mesh read() {
        for (const PlyElement& element : header_.elements) {
            if (element.name == "vertex")
                readVertices(element);
            else if (element.name == "face")
                readFaces(element);
            else
                skip(element);
        }
        return std::move(mesh_);
    }

private:
    [[noreturn]] void fail(std::string_view message) const {
        throw Error(fmt::format("{}: {}", name_, message));
    }

    double value(PlyType type) {
        if (header_.encoding == PlyEncoding::text) {
            const std::string_view word = scanner_.wordOnAnyLine();
            if (word.empty()) fail("cut off");
            const std::optional<float> number = floatOf(word);
            if (const std::optional<std::int64_t> whole = integerOf(word))
                return static_cast<double>(*whole);  // indices have more digits than floats
            if (!number) fail(fmt::format("'{}' where a number was expected", printable(word)));
            return *number;
        }
        const std::size_t size = sizeOf(type);
        if (left_.size() < size) fail("cut off");
        std::array<std::byte, 8> buffer;
        std::copy_n(left_.data(), size, buffer.data());
        left_ = left_.subspan(size);
        if (header_.encoding == PlyEncoding::bigEndian)
            std::reverse(buffer.begin(), buffer.begin() + static_cast<std::ptrdiff_t>(size));
        return load(buffer.data(), type);
    }

    std::uint64_t wholeNumber(PlyType type, std::uint64_t below, const char* what) {
        const double number = value(type);
        if (!(number >= 0.0 && number < static_cast<double>(below) && number == std::floor(number)))
            fail(fmt::format("{} {}; expected a whole number below {}", what, number, below));
        return static_cast<std::uint64_t>(number);
    }

    // What a list takes at least, in bytes, is left: counts cannot make anything be allocated.
    std::uint64_t listLength(const PlyProperty& property) {
        const std::uint64_t length =
            wholeNumber(property.countType, std::uint64_t{1} << 31, "a list of");
        if (header_.encoding != PlyEncoding::text && length > left_.size() / sizeOf(property.type))
            fail("cut off");
        return length;
    }

    void skip(const PlyProperty& property) {
        const std::uint64_t length = property.isList ? listLength(property) : 1;
        for (std::uint64_t i = 0; i < length; ++i) (void)value(property.type);
    }

    void skip(const PlyElement& element) {
        for (std::uint64_t i = 0; i < element.count; ++i)
            for (const PlyProperty& property : element.properties) skip(property);
    }

    void readVertices(const PlyElement& element) {
        const std::size_t none = element.properties.size();
        constexpr const char* kNames[] = {"x", "y", "z", "nx", "ny", "nz"};
        std::vector<int> slots(none, -1);  // of each property, which of these it is
        int found = 0;
        for (int i = 0; i < 6; ++i) {
            const std::size_t property = element.find(kNames[i]);
            if (property == none || element.properties[property].isList) {
                if (i < 3) fail(fmt::format("vertices without '{}'", kNames[i]));
                continue;
            }
            slots[property] = i;
            ++found;
        }
        const bool hasNormals = found == 6;
        mesh_.positions.reserve(element.count);
        if (hasNormals) mesh_.normals.reserve(element.count);
        float values[6] = {};
        for (std::uint64_t i = 0; i < element.count; ++i) {
            for (std::size_t p = 0; p < none; ++p) {
                if (slots[p] < 0)
                    skip(element.properties[p]);
                else
                    values[slots[p]] = static_cast<float>(value(element.properties[p].type));
            }
            mesh_.positions.emplace_back(values[0], values[1], values[2]);
            if (hasNormals) mesh_.normals.emplace_back(values[3], values[4], values[5]);
        }
    }

    void readFaces(const PlyElement& element) {
        std::size_t indices = element.find("vertex_indices");
        if (indices == element.properties.size()) indices = element.find("vertex_index");
        if (indices == element.properties.size() || !element.properties[indices].isList)
            fail("faces without a list of 'vertex_indices'");
        mesh_.triangles.reserve(element.count);
        for (std::uint64_t i = 0; i < element.count; ++i)
            for (std::size_t p = 0; p < element.properties.size(); ++p) {
                if (p == indices)
                    readFace(element.properties[p]);
                else
                    skip(element.properties[p]);
            }
    }

    void readFace(const PlyProperty& property) {
        const std::uint64_t length = listLength(property);
        face_.clear();
        for (std::uint64_t i = 0; i < length; ++i)
            face_.push_back(static_cast<unsigned>(
                wholeNumber(property.type, mesh_.positions.size(), "a face with vertex")));
        if (length < 3) return;  // points and edges
        if (length == 3) {
            mesh_.triangles.emplace_back(face_[0], face_[1], face_[2]);
            return;
        }
        outline_.clear();
        for (const unsigned vertex : face_) outline_.push_back(mesh_.positions[vertex]);
        cut_.clear();
        triangulate(outline_, cut_);
        for (const glm::uvec3 t : cut_)
            mesh_.triangles.emplace_back(face_[t.x], face_[t.y], face_[t.z]);
    }

    std::string name_;
    PlyHeader header_;
    std::span<const std::byte> left_;  // of a binary file
    TextScanner scanner_;              // of a text file
    Mesh mesh_;
    std::vector<unsigned> face_;  // scratch space of readFace()
    std::vector<glm::vec3> outline_;
    std::vector<glm::uvec3> cut_;
};

}  // namespace

Scene loadPly(const std::filesystem::path& path, std::span<const std::byte> bytes,
              const ModelOptions& options) {
    return singlePart(path, PlyReader(path, bytes).read(), options);
}

}  // namespace tukor
