// An environment made quick to look up: a mip chain of bordered panels, four floats a texel.
#pragma once
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "tukor/environment/cube_map.h"
#include "tukor/image/image.h"

namespace tukor::trace {

/// Radiance by direction and footprint; seamless, trilinear. Read-only: threads may share it.
///
/// Panels are the six faces of a cube or one equirectangular panorama. The panorama is exact where
/// a cube made of it has been resampled.
class EnvironmentMap {
public:
    /// Turned by `rotation` radians about +Y, counter-clockwise seen from above; radiance times
    /// `intensity`.
    EnvironmentMap(const CubeMap& cube, float rotation, float intensity);
    EnvironmentMap(const Image& panorama, float rotation, float intensity);

    /// `direction` is unit. Footprints below a texel are points.
    [[nodiscard]] glm::vec3 radiance(glm::vec3 direction, float solidAngle) const noexcept;

    /// The mean over the parallelogram of directions that `dx` and `dy` span, `direction` in its
    /// middle, from at most `mostLookUps` points; over more than half a radian only of that.
    [[nodiscard]] glm::vec3 radiance(glm::vec3 direction, glm::vec3 dx, glm::vec3 dy,
                                     int mostLookUps) const noexcept;

    struct alignas(16) Texel {
        float r, g, b, unused;
    };

private:
    enum class Form { cube, panorama };
    struct Level {
        int width;
        int height;
        std::unique_ptr<Texel[]> texels;  // [panel][row][column], (width + 2) * (height + 2) each
    };
    struct Place {
        std::size_t panel;
        float x;  // 0 at the left edge of the panel, 1 at its right one
        float y;
    };

    EnvironmentMap(Form form, float rotation);
    /// Its texels, to be written, of so many panels.
    Texel* addLevel(int width, int height, int panels);
    void addCubeLevel(const CubeMap& cube, float intensity);
    void addPanoramaLevel(std::span<const glm::vec3> pixels, int width, int height,
                          float intensity);
    [[nodiscard]] glm::vec3 turned(glm::vec3 direction) const noexcept;
    [[nodiscard]] glm::vec3 look(glm::vec3 turnedDirection, float level) const noexcept;
    [[nodiscard]] Place placeOf(glm::vec3 direction) const noexcept;
    [[nodiscard]] Texel bilinear(const Level& level, const Place& place) const noexcept;

    Form form_;
    float cosRotation_;
    float sinRotation_;
    int equivalentFaceSize_ = 1;  // of a cube with as many texels to the degree
    std::vector<Level> levels_;
};

}  // namespace tukor::trace
