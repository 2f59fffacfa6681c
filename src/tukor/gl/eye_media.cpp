#include "tukor/gl/eye_media.h"

#include <array>

#include "tukor/geometry/bvh_traversal.h"

namespace tukor::gl {

namespace {

constexpr int kMostCrossings = 4096;  // beyond any real model; ends rays caught between doubles

std::uint32_t mediaAlong(glm::vec3 origin, glm::vec3 direction, const Bvh& bvh,
                         std::span<const std::uint32_t> insideOfPart) {
    std::array<int, 32> crossings{};  // outwards less inwards, per medium
    int skip = -1;
    for (int i = 0; i < kMostCrossings; ++i) {
        const geometry::BvhHit hit =
            geometry::nearestBvhHit(bvh.view(), origin, direction, 0.0f, 1e30f, skip);
        if (hit.triangle < 0) break;
        const geometry::BvhSurface surface = geometry::bvhSurface(bvh.view(), hit.triangle);
        const bool outwards = glm::dot(direction, glm::cross(surface.e1, surface.e2)) > 0.0f;
        const std::uint32_t media = insideOfPart[static_cast<std::size_t>(surface.part)];
        for (std::size_t bit = 0; bit < crossings.size(); ++bit)
            if ((media >> bit & 1u) != 0) crossings[bit] += outwards ? 1 : -1;
        origin = surface.v0 + hit.u * surface.e1 + hit.v * surface.e2;
        skip = hit.triangle;
    }
    std::uint32_t media = 0;
    for (std::size_t bit = 0; bit < crossings.size(); ++bit)
        if (crossings[bit] > 0) media |= 1u << bit;
    return media;
}

}  // namespace

std::uint32_t mediaAround(glm::vec3 point, const Bvh& bvh,
                          std::span<const std::uint32_t> insideOfPart) {
    // One ray may run along an edge or leave through a hole. The directions are arbitrary but for
    // not being parallel to anything that people model.
    const std::uint32_t a = mediaAlong(point, {0.5377f, 0.7193f, -0.4399f}, bvh, insideOfPart);
    const std::uint32_t b = mediaAlong(point, {-0.6821f, 0.2753f, 0.6777f}, bvh, insideOfPart);
    const std::uint32_t c = mediaAlong(point, {0.1739f, -0.8807f, 0.4407f}, bvh, insideOfPart);
    return (a & b) | (b & c) | (a & c);
}

}  // namespace tukor::gl
