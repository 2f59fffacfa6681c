#include "tukor/scene/stl_file.h"

#include <cstdint>
#include <cstring>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/scene/interner.h"
#include "tukor/scene/sibling_file.h"
#include "tukor/scene/single_part.h"
#include "tukor/scene/text_scanner.h"

namespace tukor {

namespace {

constexpr std::size_t kHeader = 84, kFacet = 50;  // bytes

std::uint64_t facetCount(std::span<const std::byte> bytes) noexcept {
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.data() + 80, sizeof count);
    return count;
}

bool isBinary(std::span<const std::byte> bytes) noexcept {
    return bytes.size() >= kHeader && bytes.size() == kHeader + kFacet * facetCount(bytes);
}

bool startsAsText(std::span<const std::byte> bytes) {
    TextScanner scanner(bytes);
    return scanner.wordOnAnyLine() == "solid";
}

Mesh readBinary(std::span<const std::byte> bytes) {
    const std::uint64_t count = facetCount(bytes);
    Interner<glm::vec3> places(count / 2);  // closed surfaces: half as many vertices as triangles
    Mesh mesh;
    mesh.triangles.reserve(count);
    for (std::uint64_t i = 0; i < count; ++i) {
        glm::vec3 corners[3];
        std::memcpy(corners, bytes.data() + kHeader + kFacet * i + 12, sizeof corners);
        mesh.triangles.emplace_back(places.add(corners[0]), places.add(corners[1]),
                                    places.add(corners[2]));
    }
    mesh.positions = std::move(places).take();
    return mesh;
}

Mesh readText(const std::filesystem::path& path, std::span<const std::byte> bytes) {
    Interner<glm::vec3> places;
    Mesh mesh;
    unsigned loop[3] = {};
    int corners = 0;
    for (TextScanner scanner(bytes); !scanner.atEnd(); scanner.skipLine()) {
        const std::string_view key = scanner.word();
        if (key != "vertex") {
            if (key == "outer" || key == "facet") corners = 0;
            continue;
        }
        glm::vec3 place;
        for (int i = 0; i < 3; ++i) {
            const std::string_view word = scanner.word();
            const std::optional<float> number = floatOf(word);
            if (!number)
                throw Error(fmt::format("{}: line {}: '{}' where a number was expected",
                                        path.string(), scanner.line(), printable(word)));
            place[i] = *number;
        }
        if (corners == 3)
            throw Error(fmt::format("{}: line {}: a facet of more than three corners",
                                    path.string(), scanner.line()));
        loop[corners++] = places.add(place);
        if (corners == 3) mesh.triangles.emplace_back(loop[0], loop[1], loop[2]);
    }
    mesh.positions = std::move(places).take();
    return mesh;
}

}  // namespace

Scene loadStl(const std::filesystem::path& path, std::span<const std::byte> bytes,
              const ModelOptions& options) {
    if (!isBinary(bytes)) {
        if (startsAsText(bytes)) return singlePart(path, readText(path, bytes), options);
        if (bytes.size() < kHeader)
            throw Error(fmt::format("{}: {} bytes; a binary STL has at least {}", path.string(),
                                    bytes.size(), kHeader));
        // Some writers leave something behind the last facet.
        if (bytes.size() < kHeader + kFacet * facetCount(bytes))
            throw Error(fmt::format("{}: cut off: {} bytes of {} for {} facets", path.string(),
                                    bytes.size(), kHeader + kFacet * facetCount(bytes),
                                    facetCount(bytes)));
    }
    return singlePart(path, readBinary(bytes), options);
}

}  // namespace tukor
