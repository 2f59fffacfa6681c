// A finish at one place: its textures looked up, its frame turned towards the ray.
#pragma once
#include <array>
#include <vector>

#include "tukor/trace/albedo_tables.h"
#include "tukor/trace/surfaces.h"
#include "tukor/trace/texture_lookup.h"

namespace tukor::trace {

/// What light meets there. Roughness is GGX's alpha, along the tangent and the bitangent.
struct Appearance {
    glm::vec3 n;  // shading normal, unit, on the side of the ray
    glm::vec3 t;  // tangent and bitangent, orthonormal with it
    glm::vec3 b;
    glm::vec3 coatNormal;
    glm::vec3 baseColor;
    float alpha;  // 0: nothing is there
    float metallic;
    float roughness;  // perceptual
    glm::vec2 a;
    glm::vec3 emission;
    glm::vec3 F0;   // of what is not metallic
    glm::vec3 F90;  //
    glm::vec3 metalF0;
    float transmission;  // of what is not metallic
    float coat;
    float coatRoughness;
    glm::vec3 sheen;
    float sheenRoughness;
};

/// The finishes of a scene, by part; null where a part is ideally smooth. The scene must outlive
/// it.
class FinishTable {
public:
    explicit FinishTable(const Scene& scene);

    [[nodiscard]] bool empty() const noexcept { return empty_; }
    [[nodiscard]] const Finish* finishOf(int surface) const noexcept {
        return empty_ ? nullptr : parts_[static_cast<std::size_t>(surface)].finish;
    }

    /// `at` is the ray's footprint on the surface. For parts with a finish.
    [[nodiscard]] Appearance at(const RayHit& hit, const transport::SurfaceHit& surface,
                                const transport::Facing& face, glm::vec3 d,
                                const transport::Footprint& at) const noexcept;

    /// What a ray passes by alpha.
    [[nodiscard]] float clearness(const RayHit& hit,
                                  const transport::SurfaceHit& surface) const noexcept;

    /// Of a part that is solid, where light enters from the vacuum, or leaves to it.
    [[nodiscard]] const ClearAlbedo* clearAlbedo(int surface, bool entering) const noexcept {
        const PartFinish& part = parts_[static_cast<std::size_t>(surface)];
        return entering ? part.entering.get() : part.leaving.get();
    }

private:
    struct PartFinish {
        const Finish* finish = nullptr;
        const Mesh* mesh = nullptr;
        std::array<const TexturePyramid*, kTextureRoles> pyramids{};
        std::shared_ptr<const ClearAlbedo> entering = nullptr;
        std::shared_ptr<const ClearAlbedo> leaving = nullptr;
    };
    /// The place on the surface in every coordinate that textures use.
    struct Place {
        const PartFinish* part;
        glm::uvec3 corners;
        glm::vec3 weights;
        glm::vec2 uv[2];
        float width[2];  // of the footprint
    };
    [[nodiscard]] Place placeOf(const RayHit& hit, const transport::SurfaceHit& surface,
                                float area) const noexcept;
    [[nodiscard]] static glm::vec4 look(const Place& place, TextureRole role) noexcept;
    [[nodiscard]] static glm::vec4 baseColorAt(const Place& place) noexcept;

    std::vector<PartFinish> parts_;
    TextureStore store_;
    bool empty_ = true;
};

}  // namespace tukor::trace
