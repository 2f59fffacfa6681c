// An environment made quick to look up: a mip chain of bordered panels, four floats a texel.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numbers>
#include <span>
#include <vector>

#include "tukor/environment/cube_map.h"
#include "tukor/image/image.h"

namespace tukor::trace {

/// Footprints are clamped to 16 texels (transport/footprint.h): no more levels are ever read.
inline constexpr int kEnvironmentLevels = 5;

/// Look-ups that are done together: eight at a time, and the texels of all are fetched before the
/// first is summed.
struct LookUpBatch {
    static constexpr int kRoom = 128;
    struct alignas(16) Texel {
        float r, g, b, unused;
    };

    int count = 0;
    alignas(64) std::array<float, kRoom> x, y, z;  // directions of any length, turned with the map
    alignas(64) std::array<float, kRoom> level;
    std::array<Texel, kRoom> found;  // by EnvironmentMap::look

    [[nodiscard]] int room() const noexcept { return kRoom - count; }
    /// The sum of what some look-ups have found.
    [[nodiscard]] glm::vec3 sum(int first, int number) const noexcept;
};

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

    /// Puts the same look-ups, one or at most `mostLookUps`, for which there must be room, into a
    /// batch. How many they are.
    int add(LookUpBatch& batch, glm::vec3 direction, float solidAngle) const noexcept;
    int add(LookUpBatch& batch, glm::vec3 direction, glm::vec3 dx, glm::vec3 dy,
            int mostLookUps) const noexcept;

    /// Does what the batch asks for.
    void look(LookUpBatch& batch) const noexcept;

    /// Of the finest level, on average.
    [[nodiscard]] float texelsPerSteradian() const noexcept {
        const auto size = static_cast<float>(equivalentFaceSize_);
        return 6.0f * size * size / (4.0f * std::numbers::pi_v<float>);
    }

    using Texel = LookUpBatch::Texel;

private:
    enum class Form { cube, panorama };
    struct Level {
        int width;
        int height;
        std::unique_ptr<Texel[]> texels;  // [panel][row][column], (width + 2) * (height + 2) each
    };

    EnvironmentMap(Form form, float rotation);
    /// Its texels, to be written, of so many panels.
    Texel* addLevel(int width, int height, int panels);
    void addCubeLevel(const CubeMap& cube, float intensity);
    void addPanoramaLevel(std::span<const glm::vec3> pixels, int width, int height,
                          float intensity);
    [[nodiscard]] glm::vec3 turned(glm::vec3 d) const noexcept {
        return {cosRotation_ * d.x - sinRotation_ * d.z, d.y,
                sinRotation_ * d.x + cosRotation_ * d.z};
    }

    Form form_;
    float cosRotation_;
    float sinRotation_;
    int equivalentFaceSize_ = 1;  // of a cube with as many texels to the degree
    std::vector<Level> levels_;
};

}  // namespace tukor::trace
