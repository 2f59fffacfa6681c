#include "tukor/gl/surface_buffers.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>

#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/scene/finish.h"

namespace tukor::gl {

namespace {

std::uint64_t mixed(std::uint64_t x) {  // the finaliser of splitmix64
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
    return x ^ (x >> 31);
}

/// Whether triangles pair up at every edge and enclose what they face away from.
///
/// Every edge adds a number in one direction and takes it off in the other: no sorting. Wrong with
/// a chance of 2^-64.
bool isSolid(const Mesh& mesh) {
    std::vector<std::uint64_t> places(mesh.positions.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
        const glm::vec3 p = mesh.positions[i] + 0.0f;  // makes -0 equal to 0
        std::uint32_t bits[3];
        std::memcpy(bits, &p, sizeof(bits));
        places[i] = mixed(mixed(bits[0] | std::uint64_t{bits[1]} << 32) + bits[2]);
    }
    std::uint64_t unpaired = 0;
    double volume = 0.0;
    for (const glm::uvec3& t : mesh.triangles) {
        for (int i = 0; i < 3; ++i) {
            const std::uint64_t from = places[t[i]];
            const std::uint64_t to = places[t[(i + 1) % 3]];
            unpaired += from < to ? mixed(from + 3 * to) : -mixed(to + 3 * from);
        }
        const glm::dvec3 a = mesh.positions[t.x];
        const glm::dvec3 b = mesh.positions[t.y];
        volume += glm::dot(a, glm::cross(b, glm::dvec3(mesh.positions[t.z])));
    }
    return unpaired == 0 && volume > 0.0;
}

bool contains(const Bounds& bounds, glm::vec3 p) {
    return glm::all(glm::greaterThanEqual(p, bounds.least)) &&
           glm::all(glm::lessThanEqual(p, bounds.most));
}

}  // namespace

SurfaceBuffers::SurfaceBuffers(const Scene& scene)
    : vertexArray_(VertexArray::make()), vertices_(Buffer::make()), indices_(Buffer::make()) {
    std::size_t vertexCount = 0;
    std::size_t triangleCount = 0;
    for (const Part& part : scene.parts) {
        vertexCount += part.mesh.positions.size();
        triangleCount += part.mesh.triangles.size();
    }
    // GL counts bytes and indices in signed 32 bits.
    constexpr std::size_t kMost = std::numeric_limits<std::int32_t>::max() / 24;
    if (vertexCount > kMost || triangleCount > kMost)
        throw Error(fmt::format("{} vertices and {} triangles; OpenGL draws at most {} of each",
                                vertexCount, triangleCount, kMost));

    std::vector<glm::vec3> vertices;  // position and normal in turn
    std::vector<glm::uvec3> triangles;
    vertices.reserve(2 * vertexCount);
    triangles.reserve(triangleCount);
    for (const Part& part : scene.parts) {
        const glm::uvec3 base(static_cast<std::uint32_t>(vertices.size() / 2));
        ranges_.push_back({static_cast<GLsizei>(3 * part.mesh.triangles.size()),
                           triangles.size() * sizeof(glm::uvec3), boundsOf(part.mesh),
                           isSolid(part.mesh)});
        for (std::size_t i = 0; i < part.mesh.positions.size(); ++i) {
            vertices.push_back(part.mesh.positions[i]);
            vertices.push_back(part.mesh.normals[i]);
        }
        for (const glm::uvec3& triangle : part.mesh.triangles) triangles.push_back(triangle + base);
    }

    bind();
    glBindBuffer(GL_ARRAY_BUFFER, vertices_.id());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(glm::vec3)),
                 vertices.data(), GL_STATIC_DRAW);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
    glBufferData(GL_ELEMENT_ARRAY_BUFFER,
                 static_cast<GLsizeiptr>(triangles.size() * sizeof(glm::uvec3)), triangles.data(),
                 GL_STATIC_DRAW);
    for (GLuint attribute = 0; attribute < 2; ++attribute) {
        glEnableVertexAttribArray(attribute);
        glVertexAttribPointer(attribute, 3, GL_FLOAT, GL_FALSE, 2 * sizeof(glm::vec3),
                              reinterpret_cast<const void*>(attribute * sizeof(glm::vec3)));
    }
    addDetails(scene);
    glBindVertexArray(0);
}

void SurfaceBuffers::addDetails(const Scene& scene) {
    const bool wanted = std::any_of(scene.parts.begin(), scene.parts.end(), [](const Part& part) {
        return part.material.finish != nullptr;
    });
    if (!wanted) return;
    std::vector<glm::vec4> details;  // two texture coordinates, tangent, colour in turn
    for (const Part& part : scene.parts) {
        const Mesh& mesh = part.mesh;
        const auto takesColors = [&] {
            const Finish* const finish = part.material.finish.get();
            return !finish || !finish->ignoresColors;
        };
        const auto uv = [&](std::size_t set, std::size_t i) {
            return mesh.uvs[set].empty() ? glm::vec2(0.0f) : mesh.uvs[set][i];
        };
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            details.emplace_back(uv(0, i), uv(1, i));
            details.push_back(mesh.tangents.empty() ? glm::vec4(0.0f) : mesh.tangents[i]);
            details.push_back(mesh.colors.empty() || (kFinishesByName && !takesColors())
                                  ? glm::vec4(1.0f)
                                  : mesh.colors[i]);
        }
    }
    details_ = Buffer::make();
    glBindBuffer(GL_ARRAY_BUFFER, details_.id());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(details.size() * sizeof(glm::vec4)),
                 details.data(), GL_STATIC_DRAW);
    for (GLuint i = 0; i < 3; ++i) {
        glEnableVertexAttribArray(2 + i);
        glVertexAttribPointer(2 + i, 4, GL_FLOAT, GL_FALSE, 3 * sizeof(glm::vec4),
                              reinterpret_cast<const void*>(i * sizeof(glm::vec4)));
    }
}

void SurfaceBuffers::draw(int part, glm::vec3 eye) const {
    const Range& range = ranges_[static_cast<std::size_t>(part)];
    const auto* first = reinterpret_cast<const void*>(range.firstByte);
    glEnable(GL_CULL_FACE);
    glCullFace(GL_BACK);
    glDrawElements(GL_TRIANGLES, range.indices, GL_UNSIGNED_INT, first);
    if (!range.solid || contains(range.bounds, eye)) {
        glCullFace(GL_FRONT);
        glDrawElements(GL_TRIANGLES, range.indices, GL_UNSIGNED_INT, first);
    }
    glDisable(GL_CULL_FACE);
}

void SurfaceBuffers::drawBothSides(int part) const {
    const Range& range = ranges_[static_cast<std::size_t>(part)];
    const auto* first = reinterpret_cast<const void*>(range.firstByte);
    glEnable(GL_CULL_FACE);
    for (const GLenum culled : {GL_FRONT, GL_BACK}) {
        glCullFace(culled);
        glDrawElements(GL_TRIANGLES, range.indices, GL_UNSIGNED_INT, first);
    }
    glDisable(GL_CULL_FACE);
}

}  // namespace tukor::gl
