#include "tukor/scene/ply_header.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/scene/sibling_file.h"
#include "tukor/scene/text_scanner.h"

namespace tukor {

namespace {

constexpr std::size_t kMostItems = 1000;  // elements, and properties of one

constexpr std::pair<std::string_view, PlyType> kTypes[] = {
    {"char", PlyType::int8},      {"int8", PlyType::int8},       {"uchar", PlyType::uint8},
    {"uint8", PlyType::uint8},    {"short", PlyType::int16},     {"int16", PlyType::int16},
    {"ushort", PlyType::uint16},  {"uint16", PlyType::uint16},   {"int", PlyType::int32},
    {"int32", PlyType::int32},    {"uint", PlyType::uint32},     {"uint32", PlyType::uint32},
    {"float", PlyType::float32},  {"float32", PlyType::float32}, {"double", PlyType::float64},
    {"float64", PlyType::float64}};

class HeaderReader {
public:
    HeaderReader(const std::string& name, std::span<const std::byte> bytes)
        : name_(name), bytes_(bytes), scanner_(bytes) {}

    PlyHeader read() {
        if (scanner_.word() != "ply") fail("no PLY file: it does not begin with 'ply'");
        for (scanner_.skipLine();; scanner_.skipLine()) {
            if (scanner_.atEnd()) fail("a header without an end");
            const std::string_view key = scanner_.word();
            if (key == "end_header") break;
            if (key == "format") readFormat();
            if (key == "element") readElement();
            if (key == "property") readProperty();
        }
        const std::string_view text(reinterpret_cast<const char*>(bytes_.data()), bytes_.size());
        const std::size_t end = text.find('\n', text.find("end_header"));
        header_.size = end == std::string_view::npos ? bytes_.size() : end + 1;
        checkSize();
        return std::move(header_);
    }

private:
    [[noreturn]] void fail(std::string_view message) const {
        throw Error(fmt::format("{}: line {}: {}", name_, scanner_.line(), message));
    }

    void readFormat() {
        const std::string_view format = scanner_.word();
        if (format == "ascii")
            header_.encoding = PlyEncoding::text;
        else if (format == "binary_little_endian")
            header_.encoding = PlyEncoding::littleEndian;
        else if (format == "binary_big_endian")
            header_.encoding = PlyEncoding::bigEndian;
        else
            fail(
                fmt::format("format '{}'; expected ascii, binary_little_endian or "
                            "binary_big_endian",
                            printable(format)));
    }

    void readElement() {
        PlyElement element;
        element.name = scanner_.word();
        const std::string_view word = scanner_.word();
        const std::optional<std::int64_t> count = integerOf(word);
        if (!count || *count < 0)
            fail(fmt::format("'{}' where a count was expected", printable(word)));
        element.count = static_cast<std::uint64_t>(*count);
        if (header_.elements.size() == kMostItems) fail("too many elements");
        header_.elements.push_back(std::move(element));
    }

    PlyType readType(std::string_view word) const {
        for (const auto& [name, type] : kTypes)
            if (word == name) return type;
        fail(fmt::format("type '{}'; expected char to double or int8 to float64", printable(word)));
    }

    void readProperty() {
        if (header_.elements.empty()) fail("a property of no element");
        std::vector<PlyProperty>& properties = header_.elements.back().properties;
        PlyProperty property;
        std::string_view word = scanner_.word();
        if (word == "list") {
            property.isList = true;
            property.countType = readType(scanner_.word());
            word = scanner_.word();
        }
        property.type = readType(word);
        property.name = scanner_.word();
        if (properties.size() == kMostItems) fail("too many properties");
        properties.push_back(std::move(property));
    }

    // No element without bytes of its own: counts are then bounded by the file's size.
    void checkSize() const {
        std::uint64_t left = bytes_.size() - header_.size;
        for (const PlyElement& element : header_.elements) {
            std::uint64_t least = 0;  // bytes of one: empty lists, numbers of one digit
            for (const PlyProperty& property : element.properties)
                least += header_.encoding == PlyEncoding::text
                             ? 2
                             : sizeOf(property.isList ? property.countType : property.type);
            const std::uint64_t slack = header_.encoding == PlyEncoding::text ? 1 : 0;
            if (least == 0 && element.count > 0)
                throw Error(fmt::format("{}: element '{}' has no properties", name_,
                                        printable(element.name)));
            if (element.count > 0 && element.count > (left + slack) / least)
                throw Error(fmt::format("{}: {} times '{}' cannot fit into the {} bytes left",
                                        name_, element.count, printable(element.name), left));
            left -= std::min(left, element.count * least);
        }
    }

    const std::string& name_;
    std::span<const std::byte> bytes_;
    TextScanner scanner_;
    PlyHeader header_;
};

}  // namespace

std::size_t sizeOf(PlyType type) noexcept {
    constexpr std::size_t kSizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
    return kSizes[static_cast<std::size_t>(type)];
}

std::size_t PlyElement::find(const std::string& property) const noexcept {
    std::size_t i = 0;
    while (i < properties.size() && properties[i].name != property) ++i;
    return i;
}

PlyHeader readPlyHeader(const std::string& name, std::span<const std::byte> bytes) {
    return HeaderReader(name, bytes).read();
}

}  // namespace tukor
