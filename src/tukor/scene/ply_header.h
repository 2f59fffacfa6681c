// The header of a PLY file: which elements follow, and what each of them is made of.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace tukor {

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };
enum class PlyEncoding { text, littleEndian, bigEndian };

[[nodiscard]] std::size_t sizeOf(PlyType type) noexcept;  // bytes

struct PlyProperty {
    std::string name;
    PlyType type = PlyType::float32;
    bool isList = false;
    PlyType countType = PlyType::uint8;  // of lists
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;

    /// The position of a property, or of none: properties.size().
    [[nodiscard]] std::size_t find(const std::string& property) const noexcept;
};

struct PlyHeader {
    PlyEncoding encoding = PlyEncoding::text;
    std::vector<PlyElement> elements;
    std::size_t size = 0;  // bytes of the header: where the elements begin
};

/// Throws Error, opened by `name`, for anything but a well-formed header, and where the elements
/// cannot fit into the file.
[[nodiscard]] PlyHeader readPlyHeader(const std::string& name, std::span<const std::byte> bytes);

}  // namespace tukor
