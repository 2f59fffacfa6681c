#include "tukor/trace/ray_caster.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include <embree3/rtcore.h>
#include <fmt/format.h>

#include "tukor/base/error.h"

namespace tukor::trace {

namespace {

/// Rejects the triangle that the ray leaves: RTCRay::id carries its number.
void skipOwnTriangle(const RTCFilterFunctionNArguments* args) {
    const auto first =
        static_cast<unsigned>(reinterpret_cast<std::uintptr_t>(args->geometryUserPtr));
    for (unsigned i = 0; i < args->N; ++i) {
        if (args->valid[i] != -1) continue;
        const unsigned triangle = first + RTCHitN_primID(args->hit, args->N, i);
        if (triangle == RTCRayN_id(args->ray, args->N, i)) args->valid[i] = 0;
    }
}

constexpr unsigned kNoTriangle = std::numeric_limits<unsigned>::max();  // no surface has 2^32

const SurfaceTable::Entry& entryOf(void* userData) {
    return *static_cast<const SurfaceTable::Entry*>(userData);
}

void boundsOfSphere(const RTCBoundsFunctionArguments* args) {
    const Sphere& sphere = *entryOf(args->geometryUserPtr).sphere;
    const float reach = sphere.radius * (1.0f + 1e-6f);
    const glm::vec3 least = sphere.centre - reach, most = sphere.centre + reach;
    *args->bounds_o = {least.x, least.y, least.z, 0.0f, most.x, most.y, most.z, 0.0f};
}

void meetSphere(const RTCIntersectFunctionNArguments* args) {
    const SurfaceTable::Entry& entry = entryOf(args->geometryUserPtr);
    const unsigned n = args->N;
    RTCRayN* rays = RTCRayHitN_RayN(args->rayhit, n);
    RTCHitN* hits = RTCRayHitN_HitN(args->rayhit, n);
    for (unsigned i = 0; i < n; ++i) {
        if (args->valid[i] != -1) continue;
        const bool leaves = RTCRayN_id(rays, n, i) == static_cast<unsigned>(entry.firstTriangle);
        const float t = geometry::sphereDistance(
            {RTCRayN_org_x(rays, n, i), RTCRayN_org_y(rays, n, i), RTCRayN_org_z(rays, n, i)},
            {RTCRayN_dir_x(rays, n, i), RTCRayN_dir_y(rays, n, i), RTCRayN_dir_z(rays, n, i)},
            entry.sphere->centre, entry.sphere->radius, RTCRayN_tnear(rays, n, i), leaves);
        if (!(t > 0.0f) || t >= RTCRayN_tfar(rays, n, i)) continue;
        RTCRayN_tfar(rays, n, i) = t;
        RTCHitN_u(hits, n, i) = RTCHitN_v(hits, n, i) = 1.0f / 3.0f;
        RTCHitN_primID(hits, n, i) = 0;
        RTCHitN_geomID(hits, n, i) = args->geomID;
        RTCHitN_instID(hits, n, i, 0) = RTC_INVALID_GEOMETRY_ID;
    }
}

}  // namespace

struct RayCaster::Embree {
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;

    ~Embree() {
        if (scene) rtcReleaseScene(scene);
        if (device) rtcReleaseDevice(device);
    }

    void check(const char* action) const {
        const RTCError code = rtcGetDeviceError(device);
        if (code == RTC_ERROR_NONE) return;
        throw Error(fmt::format("embree: {} failed: {}", action,
                                code == RTC_ERROR_OUT_OF_MEMORY
                                    ? std::string("out of memory")
                                    : fmt::format("error {}", static_cast<int>(code))));
    }

    void addSphere(const SurfaceTable::Entry& entry) {
        RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
        rtcSetGeometryUserPrimitiveCount(geometry, 1);
        rtcSetGeometryUserData(geometry, const_cast<SurfaceTable::Entry*>(&entry));
        rtcSetGeometryBoundsFunction(geometry, boundsOfSphere, nullptr);
        rtcSetGeometryIntersectFunction(geometry, meetSphere);
        attach(geometry);
    }

    void addTriangles(const SurfaceTable::Entry& entry) {
        if (entry.indices.empty()) return;
        RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                   entry.positions.data(), 0, sizeof(glm::vec3),
                                   entry.positions.size() - 1);
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                   entry.indices.data(), 0, sizeof(glm::uvec3),
                                   entry.indices.size());
        rtcSetGeometryUserData(
            geometry, reinterpret_cast<void*>(static_cast<std::uintptr_t>(entry.firstTriangle)));
        attach(geometry);
    }

    void attach(RTCGeometry geometry) {
        rtcCommitGeometry(geometry);
        rtcAttachGeometryByID(scene, geometry, number_);
        rtcReleaseGeometry(geometry);
    }

    void addAll(const SurfaceTable& surfaces) {
        for (const SurfaceTable::Entry& entry : surfaces.entries()) {
            entry.sphere ? addSphere(entry) : addTriangles(entry);
            ++number_;
        }
    }

private:
    unsigned number_ = 0;  // that of the surface: empty ones leave a gap
};

#ifdef __SANITIZE_THREAD__
constexpr const char* kEmbreeOptions = "threads=1";  // how its threads synchronise cannot be seen
#else
constexpr const char* kEmbreeOptions = "hugepages=1";
#endif

RayCaster::RayCaster(const SurfaceTable& surfaces) : embree_(std::make_unique<Embree>()) {
    embree_->device = rtcNewDevice(kEmbreeOptions);
    if (!embree_->device) throw Error("embree: this processor is not supported");
    embree_->scene = rtcNewScene(embree_->device);
    rtcSetSceneBuildQuality(embree_->scene, RTC_BUILD_QUALITY_MEDIUM);
    rtcSetSceneFlags(embree_->scene,
                     RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION);
    embree_->addAll(surfaces);
    embree_->check("reading the triangles");
    rtcCommitScene(embree_->scene);
    embree_->check("building the tree");
}

RayCaster::~RayCaster() = default;

void RayCaster::cast(const RayPacket& rays, int count, Coherence coherence,
                     std::array<RayHit, kPacketWidth>& hits) const noexcept {
    if (watch_) watch_(rays, count, coherence);
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = coherence == Coherence::rays ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT
                                                 : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    // Camera rays leave no triangle.
    context.filter = coherence == Coherence::rays ? nullptr : skipOwnTriangle;
    RTCRayHit8 packet;
    alignas(32) int valid[kPacketWidth];
    static_assert(sizeof rays.originX == sizeof packet.ray.org_x);
    std::memcpy(packet.ray.org_x, rays.originX.data(), sizeof packet.ray.org_x);
    std::memcpy(packet.ray.org_y, rays.originY.data(), sizeof packet.ray.org_y);
    std::memcpy(packet.ray.org_z, rays.originZ.data(), sizeof packet.ray.org_z);
    std::memcpy(packet.ray.dir_x, rays.directionX.data(), sizeof packet.ray.dir_x);
    std::memcpy(packet.ray.dir_y, rays.directionY.data(), sizeof packet.ray.dir_y);
    std::memcpy(packet.ray.dir_z, rays.directionZ.data(), sizeof packet.ray.dir_z);
    std::memcpy(packet.ray.tnear, rays.beyond.data(), sizeof packet.ray.tnear);
    std::memcpy(packet.ray.id, rays.skip.data(), sizeof packet.ray.id);  // -1 is kNoTriangle
    for (int i = 0; i < kPacketWidth; ++i) {
        valid[i] = i < count ? -1 : 0;
        packet.ray.tfar[i] = std::numeric_limits<float>::infinity();
        packet.ray.time[i] = 0.0f;
        packet.ray.mask[i] = kNoTriangle;
        packet.ray.flags[i] = 0;
        packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
        packet.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
    }
    rtcIntersect8(valid, embree_->scene, &context, &packet);
    for (int i = 0; i < count; ++i) {
        hits[static_cast<std::size_t>(i)] = {packet.ray.tfar[i], packet.hit.u[i], packet.hit.v[i],
                                             static_cast<int>(packet.hit.geomID[i]),
                                             static_cast<int>(packet.hit.primID[i])};
    }
}

RayHit RayCaster::cast(glm::vec3 origin, glm::vec3 direction, int skip,
                       float beyond) const noexcept {
    RayPacket packet{};
    // A neighbour in the same plane is met at 0, which Embree takes for not nearer than 0.
    packet.beyond[0] = std::max(std::nextafter(beyond, std::numeric_limits<float>::infinity()),
                                std::numeric_limits<float>::min());
    packet.set(0, origin, direction, skip);
    std::array<RayHit, kPacketWidth> hits;
    cast(packet, 1, Coherence::none, hits);
    return hits[0];
}

}  // namespace tukor::trace
