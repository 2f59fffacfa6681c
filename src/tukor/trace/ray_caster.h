// Nearest hits along rays, eight at a time. The file behind it is the only one that knows Embree.
#pragma once
#include <array>
#include <functional>
#include <memory>
#include <utility>

#include "tukor/trace/surfaces.h"

namespace tukor::trace {

inline constexpr int kPacketWidth = 8;

/// Up to eight rays. Each starts at its origin, without an epsilon, and does not see the triangle
/// `skip` (a number among all of the table, -1 for none).
struct alignas(32) RayPacket {
    std::array<float, kPacketWidth> originX, originY, originZ;
    std::array<float, kPacketWidth> directionX, directionY, directionZ;
    std::array<int, kPacketWidth> skip;
    std::array<float, kPacketWidth> beyond{};  // sees only what is farther

    void set(int lane, glm::vec3 origin, glm::vec3 direction, int skipped) noexcept {
        const auto i = static_cast<std::size_t>(lane);
        originX[i] = origin.x;
        originY[i] = origin.y;
        originZ[i] = origin.z;
        directionX[i] = direction.x;
        directionY[i] = direction.y;
        directionZ[i] = direction.z;
        skip[i] = skipped;
    }
};

/// Whether the rays of a packet lie close together: camera rays do.
enum class Coherence { none, rays };

/// The search structure over a table's triangles, which must outlive it. Threads may share it.
class RayCaster {
public:
    /// Builds the tree with all threads. Throws Error when Embree or the memory fails.
    explicit RayCaster(const SurfaceTable& surfaces);
    ~RayCaster();
    RayCaster(const RayCaster&) = delete;
    RayCaster& operator=(const RayCaster&) = delete;

    /// The nearest triangles along the first `count` rays of a packet.
    void cast(const RayPacket& rays, int count, Coherence coherence,
              std::array<RayHit, kPacketWidth>& hits) const noexcept;

    /// One ray; sees only what is farther than `beyond`.
    [[nodiscard]] RayHit cast(glm::vec3 origin, glm::vec3 direction, int skip,
                              float beyond = 0.0f) const noexcept;

    /// For measurements: is shown every packet before it is cast. Threads must not share the
    /// caster.
    using Watch = std::function<void(const RayPacket& rays, int count, Coherence coherence)>;
    void watch(Watch watch) { watch_ = std::move(watch); }

private:
    struct Embree;
    std::unique_ptr<Embree> embree_;
    Watch watch_;
};

}  // namespace tukor::trace
