// glTF files made for tests: a document of JSON, and bytes laid out by hand.
#pragma once
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>

#include "tukor/base/error.h"

namespace tukor::test {

/// Raw little-endian bytes of any plain values.
class Bytes {
public:
    template <class T>
    Bytes& add(const T& value) {
        const auto* from = reinterpret_cast<const char*>(&value);
        text_.append(from, sizeof(T));
        return *this;
    }
    template <class T>
    Bytes& add(std::initializer_list<T> values) {
        for (const T& value : values) add(value);
        return *this;
    }
    [[nodiscard]] const std::string& text() const noexcept { return text_; }

private:
    std::string text_;
};

inline std::string base64(std::string_view bytes) {
    constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        unsigned bits = 0;
        for (std::size_t j = 0; j < 3; ++j)
            bits =
                bits << 8 | (i + j < bytes.size() ? static_cast<unsigned char>(bytes[i + j]) : 0u);
        for (std::size_t j = 0; j < 4; ++j)
            text += i + j < bytes.size() + 1 ? kDigits[bits >> (18 - 6 * j) & 63] : '=';
    }
    return text;
}

/// `{"byteLength": N, "uri": "data:..."}` for the buffers array.
inline std::string buffer(const Bytes& bytes) {
    return R"({"byteLength": )" + std::to_string(bytes.text().size()) +
           R"(, "uri": "data:application/octet-stream;base64,)" + base64(bytes.text()) + R"("})";
}

/// A tetrahedron with faces of 12 uint16 indices (24 bytes) after 4 positions (48 bytes), wound
/// outwards: accessor 0 its positions, accessor 1 its indices. `rest` adds members to the document.
inline std::string tetrahedron(const std::string& rest) {
    Bytes bytes;
    bytes.add({glm::vec3(0), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, 0, 1)});
    bytes.add<std::uint16_t>({0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2});
    return R"({"asset": {"version": "2.0"}, "buffers": [)" + buffer(bytes) + R"(],
        "bufferViews": [{"buffer": 0, "byteLength": 48},
                        {"buffer": 0, "byteOffset": 48, "byteLength": 24}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 4},
                      {"bufferView": 1, "componentType": 5123, "type": "SCALAR", "count": 12}])" +
           (rest.empty() ? "" : ",\n") + rest + "}";
}

/// The usual rest: one mesh of the tetrahedron in a scene of one node.
inline const std::string kOneMesh =
    R"("meshes": [{"name": "tetra", "primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
       "nodes": [{"mesh": 0}], "scenes": [{"nodes": [0]}])";

/// The message of the Error that `action` throws.
template <class Action>
std::string messageOf(const Action& action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

}  // namespace tukor::test
