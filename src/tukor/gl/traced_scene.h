// A scene as the tracing shader reads it: triangles and their tree, materials, media.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "tukor/geometry/bvh.h"
#include "tukor/gl/finish_tables.h"
#include "tukor/gl/handles.h"
#include "tukor/gl/program.h"
#include "tukor/scene/scene.h"

namespace tukor::gl {

class TracedScene {
public:
    TracedScene() = default;

    /// Builds the tree and uploads everything. Throws Error for what the driver cannot hold.
    explicit TracedScene(const Scene& scene);

    /// False for an empty one that was never given a scene.
    [[nodiscard]] bool ready() const noexcept { return nodes_.id() != 0; }

    /// The scene has other materials now; one per part.
    void setMaterials(const std::vector<Material>& materials);

    /// Whether some part had a finish when the scene was given.
    [[nodiscard]] bool finished() const noexcept { return finishes_.has_value(); }

    /// Whether a medium refracts each wavelength in another way.
    [[nodiscard]] bool disperses() const noexcept;

    /// Lines of #define for traced.frag.
    [[nodiscard]] const char* defines() const noexcept {
        return finishes_ ? finishes_->defines() : "";
    }

    /// Draws all triangles in the order of the tree, with first_hit.vert as the vertex shader.
    void drawTriangles(const Program& program) const;

    /// Binds the textures from `unit` on, six of them, and sets the uniforms of traced.frag that
    /// belong to the scene; `eye` decides the media that a camera ray starts in.
    void bind(const Program& program, int unit, glm::vec3 eye);

private:
    /// Names, materials and bounds of the parts: each mesh has two corners of its box alone.
    Scene outline_;
    Bvh bvh_;                         // for the media around the eye; normals are on the GPU alone
    std::vector<glm::vec4> spheres_;  // parts that are whole spheres, as traced.frag has them
    std::vector<std::uint32_t> insideOfPart_;
    std::vector<glm::vec4> media_;
    std::vector<glm::vec4> dispersions_;  // four to a vector
    Texture nodes_;
    Texture triangles_;
    Texture normals_;
    Texture surfaces_;
    std::optional<FinishTables> finishes_;  // none where no part has one
    glm::vec3 eye_{0.0f};
    std::uint32_t eyeMedia_ = 0;
    bool eyeKnown_ = false;
};

}  // namespace tukor::gl
