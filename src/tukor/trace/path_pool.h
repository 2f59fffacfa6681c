// Many light paths at once: trees in a pool whose rays are cast in full packets.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "tukor/trace/event_lanes.h"
#include "tukor/trace/frame.h"
#include "tukor/trace/rough_event.h"
#include "tukor/trace/sampler.h"

namespace tukor::trace {

/// A part of the picture whose light is asked for.
struct CameraSample {
    glm::vec2 middle;  // pixels from the top-left corner
    glm::vec2 size;    // likewise
    int target;        // index of the sum it counts in
    std::uint32_t seed;
    PathSampler sampler{};
    float weight = 1.0f;
    glm::vec2 onLens{0.0f};  // of the unit disc
    float lensSize = 0.0f;   // of the part of the lens that it stands for, likewise
};

struct PixelSum {
    glm::vec3 radiance{0.0f};
    float coverage = 0.0f;     // samples that met a surface
    float rays = 0.0f;         // that they took
    glm::vec3 doubtful{0.0f};  // of radiance: lamps that wide look-ups saw, rightly or not
};

struct TraceCounts {
    std::uint64_t rays = 0;
    std::uint64_t leaks = 0;
    std::uint64_t inconsistencies = 0;
    std::uint64_t truncated = 0;

    void add(const TraceCounts& other) noexcept {
        rays += other.rays;
        leaks += other.leaks;
        inconsistencies += other.inconsistencies;
        truncated += other.truncated;
    }
};

/// One thread's work space. Results depend on the samples alone, not on what was traced before.
class PathPool {
public:
    explicit PathPool(const Frame& frame);

    /// Adds the light of every sample to its sum.
    void trace(std::span<const CameraSample> samples, std::span<PixelSum> sums);
    /// The same of samples that are known to meet nothing, each as good as a ray by its weight.
    void lookPast(std::span<const CameraSample> samples, std::span<PixelSum> sums);

    [[nodiscard]] const TraceCounts& counts() const noexcept { return counts_; }

private:
    struct Path {
        transport::Tree tree;
        glm::vec3 radiance{0.0f};
        std::uint32_t sample;  // of those under way
        bool grazing = false;  // its tree was not followed: see splitGrazing
        PathSampler sampler{};
        Chosen chosen{};          // where RoughEvent chose the branch's direction
        float wavelength = 0.0f;  // nm; 0 until something disperses the light
        float covered = 1.0f;     // of what lies behind the sample; 1 but for shadows on nothing
    };
    struct FirstHit {
        RayHit hit;
        std::uint32_t sample;
    };
    /// The mean of some look-ups, to be counted in a sum.
    struct Owed {
        glm::vec3 weight;
        int target;
        int lookUps;
        bool wide = false;
    };

    void traceAll();
    /// Traces all, and what was faulty again, elsewhere.
    void traceConsistently();
    void castCameraRays();
    /// What a camera ray sees that meets nothing.
    void miss(const CameraSample& sample) noexcept;
    /// The ray of a sample that meets something, or nothing, at `distance`.
    [[nodiscard]] transport::Branch cameraBranch(const CameraSample& sample,
                                                 float distance) const noexcept;
    void start(Path& path, const FirstHit& first) const noexcept;
    /// What up to eight rays have met, each that of the path of that number.
    void meetTogether(std::span<const std::uint8_t> numbers,
                      const std::array<RayHit, kPacketWidth>& hits) noexcept;
    /// The same of one.
    void meet(Path& path, const RayHit& found) noexcept;
    /// Light that meets a surface of something that disperses it goes on as that of one wavelength.
    void disperse(Path& path, const transport::Encounter& met) const noexcept;
    [[nodiscard]] transport::Medium mediumOf(const Path& path, int number) const noexcept;
    void collect(const Path& path, const transport::Deposits& deposits) noexcept;
    /// Owes a look-up: as a transport::Deposit has it.
    void collect(const CameraSample& sample, const glm::vec3& throughput,
                 const glm::vec3& direction, const glm::vec3& directionX,
                 const glm::vec3& directionY) noexcept;
    /// Does the look-ups that are owed.
    void settle() noexcept;
    /// Where a surface is not smooth, or the light of one was sampled; false: it is another's work.
    [[nodiscard]] bool meetRough(Path& path, const RayHit& hit,
                                 const transport::SurfaceHit& surface,
                                 const transport::Encounter& met) const noexcept;
    /// Runs events that need no ray; false when the path has ended.
    [[nodiscard]] bool wantsRay(Path& path) noexcept;
    void finish(const Path& path) noexcept;
    /// In place of the samples that graze curved surfaces, 16 in the square of each.
    [[nodiscard]] std::vector<CameraSample> splitGrazing() const;

    const Frame& frame_;
    std::span<const CameraSample> samples_;  // those under way
    std::span<PixelSum> sums_;
    EventLanes lanes_;
    LookUpBatch lookUps_;
    std::vector<Owed> owed_;
    std::vector<Path> paths_;
    std::vector<FirstHit> firstHits_;
    std::vector<std::uint32_t> grazing_;
    bool splits_ = false;  // samples that graze
    std::vector<std::uint32_t> faulty_;
    bool retakes_ = false;  // samples whose path was faulty
    TraceCounts counts_;
};

}  // namespace tukor::trace
