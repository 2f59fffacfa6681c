// What the tracing shader knows of surfaces with a finish: figures, coordinates, small pictures.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "tukor/geometry/bvh.h"
#include "tukor/gl/handles.h"
#include "tukor/gl/program.h"
#include "tukor/scene/scene.h"

namespace tukor::gl {

/// Texels of a part in the table of finish_hit.glsl: three of the transport's, six more.
inline constexpr std::size_t kTexelsPerPart = 9;

class FinishTables {
public:
    FinishTables() = default;
    FinishTables(const Scene& scene, const Bvh& bvh);

    /// Lines of #define for traced.frag.
    [[nodiscard]] const char* defines() const noexcept {
        return details_.id() != 0 ? "#define FINISHES\n#define DETAILS\n" : "#define FINISHES\n";
    }

    /// Writes the finish of a part into its texels of the table.
    void describe(std::size_t part, const Material& material, std::span<glm::uvec4> texels) const;

    /// Binds the textures to `unit` and the next.
    void bind(const Program& program, int unit) const;

private:
    /// Its pictures: those of colour, metallic-roughness and emission that lie alike on the part;
    /// the means of the others.
    struct Pictures {
        std::uint32_t bits = 0;  // as finish_hit.glsl has them
        glm::mat3x2 imageFromUv{1.0f};
        glm::vec4 baseColor{1.0f};
        glm::vec4 figures{1.0f};
        glm::vec4 emission{1.0f};
        float transmission = 1.0f;
    };
    std::vector<Pictures> pictures_;  // of every part
    Texture details_;
    Texture layers_;
};

}  // namespace tukor::gl
