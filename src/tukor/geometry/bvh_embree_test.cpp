// The Bvh against Embree. Built where Embree is.
#ifdef TUKOR_HAS_EMBREE
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <random>
#include <vector>

#include <embree3/rtcore.h>
#include <gtest/gtest.h>

#include "tukor/base/parallel.h"
#include "tukor/geometry/bvh.h"
#include "tukor/geometry/bvh_traversal.h"
#include "tukor/geometry/shapes.h"

namespace tukor {
namespace {

constexpr float kFar = 1e30f;

class Embree {
public:
    explicit Embree(const std::vector<const Mesh*>& parts) : device_(rtcNewDevice("threads=1")) {
        scene_ = rtcNewScene(device_);
        rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
        for (const Mesh* part : parts) {
            RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
            auto* vertices = static_cast<glm::vec3*>(
                rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12,
                                        part->positions.size()));
            std::copy(part->positions.begin(), part->positions.end(), vertices);
            auto* indices = static_cast<glm::uvec3*>(rtcSetNewGeometryBuffer(
                geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, part->triangles.size()));
            std::copy(part->triangles.begin(), part->triangles.end(), indices);
            rtcCommitGeometry(geometry);
            rtcAttachGeometry(scene_, geometry);
            rtcReleaseGeometry(geometry);
        }
        rtcCommitScene(scene_);
    }
    ~Embree() {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }
    Embree(const Embree&) = delete;
    Embree& operator=(const Embree&) = delete;

    [[nodiscard]] RTCRayHit trace(glm::vec3 origin, glm::vec3 direction) const {
        RTCRayHit ray{};
        ray.ray.org_x = origin.x, ray.ray.org_y = origin.y, ray.ray.org_z = origin.z;
        ray.ray.dir_x = direction.x, ray.ray.dir_y = direction.y, ray.ray.dir_z = direction.z;
        ray.ray.tfar = kFar;
        ray.ray.mask = ~0u;
        ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        rtcIntersect1(scene_, &context, &ray);
        return ray;
    }

private:
    RTCDevice device_;
    RTCScene scene_;
};

// A quarter of a million rays over all shapes, or eight million: the same triangle, or one that is
// as near, for a ray through an edge; and a hit where Embree has one, unless the ray grazes the
// silhouette within a rounding.
TEST(BvhEmbree, FindsTheSameTriangles) {
    for (std::string_view name : shapeNames()) {
        const auto parts = makeShape(name);
        std::vector<const Mesh*> meshes;
        for (const ShapePart& part : *parts) meshes.push_back(&part.mesh);
        const Bvh bvh = buildBvh(meshes);
        const Embree embree(meshes);
        const int rays = std::getenv("TUKOR_SLOW_TESTS") != nullptr ? 1000000 : 30000;
        std::atomic<int> hits = 0, otherTriangle = 0, otherDistance = 0, missed = 0, invented = 0;
        parallelFor(0, rays, 8192, [&](int begin, int end) {
            std::mt19937 random(static_cast<unsigned>(begin) + 1);
            std::normal_distribution<float> normal;
            const auto spread = [&] {
                return glm::vec3(normal(random), normal(random), normal(random));
            };
            for (int i = begin; i < end; ++i) {
                const glm::vec3 origin =
                    i % 2 == 0 ? 0.7f * spread() : 4.0f * glm::normalize(spread());
                const glm::vec3 direction =
                    glm::normalize(i % 2 == 0 ? spread() : 0.4f * spread() - origin);
                const geometry::BvhHit ours =
                    geometry::nearestBvhHit(bvh.view(), origin, direction, 0.0f, kFar, -1);
                const RTCRayHit theirs = embree.trace(origin, direction);
                const bool theirHit = theirs.hit.geomID != RTC_INVALID_GEOMETRY_ID;
                if (ours.triangle < 0 || !theirHit) {
                    if (theirHit) ++missed;
                    if (ours.triangle >= 0) ++invented;
                    continue;
                }
                ++hits;
                const BvhSource source = bvh.sources[ours.triangle];
                if (source.part != theirs.hit.geomID || source.triangle != theirs.hit.primID)
                    ++otherTriangle;
                // 1e-5 of the distances at hand, 100 roundings, for rays that graze a surface.
                if (std::abs(ours.t - theirs.ray.tfar) > 1e-5f * std::max(1.0f, ours.t))
                    ++otherDistance;
            }
        });
        EXPECT_GT(hits, rays / 5) << name;
        EXPECT_LE(otherTriangle, rays / 20000) << name;
        EXPECT_LE(otherDistance, rays / 20000) << name;
        EXPECT_LE(missed, 1) << name;
        EXPECT_LE(invented, 1) << name;
    }
}

}  // namespace
}  // namespace tukor
#endif
