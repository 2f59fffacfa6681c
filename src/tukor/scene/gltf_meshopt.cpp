#include "tukor/scene/gltf_meshopt.h"

#include <string>

#include <fmt/format.h>
#include <meshoptimizer.h>

#include "tukor/scene/sibling_file.h"

namespace tukor {

namespace {

void applyFilter(const JsonItem& extension, std::vector<std::byte>& bytes, std::size_t count,
                 std::size_t stride) {
    const std::string filter = extension.textOr("filter", "NONE");
    if (filter == "OCTAHEDRAL" && (stride == 4 || stride == 8))
        meshopt_decodeFilterOct(bytes.data(), count, stride);
    else if (filter == "QUATERNION" && stride == 8)
        meshopt_decodeFilterQuat(bytes.data(), count, stride);
    else if (filter == "EXPONENTIAL" && stride % 4 == 0)
        meshopt_decodeFilterExp(bytes.data(), count, stride);
    else if (filter != "NONE")
        extension.fail(fmt::format("filter '{}' for a stride of {}", printable(filter), stride));
}

}  // namespace

std::vector<std::byte> meshoptDecoded(const JsonItem& extension,
                                      std::span<const std::byte> compressed) {
    const std::string_view mode = extension.at("mode").text();
    const std::size_t count = extension.at("count").count();
    const std::size_t stride = extension.at("byteStride").count();
    const bool vertices = mode == "ATTRIBUTES", triangles = mode == "TRIANGLES";
    if (!vertices && !triangles && mode != "INDICES")
        extension.fail(
            fmt::format("mode '{}'; expected ATTRIBUTES, TRIANGLES or INDICES", printable(mode)));
    if (vertices ? stride == 0 || stride > 256 || stride % 4 != 0 : stride != 2 && stride != 4)
        extension.fail(fmt::format("a stride of {} bytes for {}", stride, mode));
    if (triangles && count % 3 != 0)
        extension.fail(fmt::format("{} indices; expected three for each triangle", count));

    // Sixteen bytes of a vertex stream take two bits at least; a triangle and an index one byte.
    const std::size_t size = compressed.size();
    const bool possible = vertices    ? count <= 64 * size / stride + 16
                          : triangles ? count / 3 <= size
                                      : count <= size;
    if (!possible)
        extension.fail(fmt::format("{} elements cannot come out of {} bytes", count, size));

    std::vector<std::byte> bytes(count * stride);
    const auto* const from = reinterpret_cast<const unsigned char*>(compressed.data());
    const int error = vertices ? meshopt_decodeVertexBuffer(bytes.data(), count, stride, from, size)
                      : triangles
                          ? meshopt_decodeIndexBuffer(bytes.data(), count, stride, from, size)
                          : meshopt_decodeIndexSequence(bytes.data(), count, stride, from, size);
    if (error != 0)
        extension.fail(fmt::format("{} bytes that do not decode to {} elements", size, count));
    if (vertices) applyFilter(extension, bytes, count, stride);
    return bytes;
}

}  // namespace tukor
