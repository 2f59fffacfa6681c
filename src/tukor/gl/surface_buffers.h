// The scene's meshes as vertex and index buffers.
#pragma once
#include <vector>

#include "tukor/gl/handles.h"
#include "tukor/scene/scene.h"

namespace tukor::gl {

/// All parts in one vertex and one index buffer; a part is a range of indices.
class SurfaceBuffers {
public:
    SurfaceBuffers() = default;
    explicit SurfaceBuffers(const Scene& scene);

    [[nodiscard]] int parts() const noexcept { return static_cast<int>(ranges_.size()); }
    [[nodiscard]] const Bounds& boundsOfPart(int part) const {
        return ranges_[static_cast<std::size_t>(part)].bounds;
    }
    void bind() const { glBindVertexArray(vertexArray_.id()); }

    /// Draws one part, as seen from `eye`, with the program and the vertex array that are bound.
    ///
    /// Triangles turned away come last, so that they are seldom shaded; where they cannot be seen,
    /// from outside of a solid, not at all. Changes face culling.
    void draw(int part, glm::vec3 eye) const;

    /// Draws one part that can be seen through: all triangles, those turned away first.
    void drawBothSides(int part) const;

private:
    void addDetails(const Scene& scene);

    struct Range {
        GLsizei indices = 0;
        std::size_t firstByte = 0;
        Bounds bounds;
        bool solid = false;
    };
    VertexArray vertexArray_;
    Buffer vertices_;
    Buffer details_;  // texture coordinates, tangents and colours, where a part has a finish
    Buffer indices_;
    std::vector<Range> ranges_;
};

}  // namespace tukor::gl
