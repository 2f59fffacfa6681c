#include "tukor/trace/layers.h"

#include <algorithm>
#include <string>

#include "tukor/base/parallel.h"

namespace tukor::trace {

namespace {

std::string nameOf(AovLayer layer) {
    switch (layer) {
        case AovLayer::depth:
            return "depth";
        case AovLayer::normal:
            return "normal";
        case AovLayer::material:
            return "material";
        case AovLayer::bounces:
            return "bounces";
    }
    return "";
}

/// Events along the longest branch; every light branch is followed too.
int bouncesAlong(const Frame& frame, const transport::Branch& ray) {
    transport::TransportSettings settings = frame.settings;
    settings.splitGain = 0.0f;
    transport::Tree tree = transport::startTree(ray, 0u, 0u);
    int most = 0;
    while (tree.alive) {
        most = std::max(most, tree.branch.depth);
        if (transport::spent(tree, settings)) {
            (void)transport::cutBranch(tree);
            continue;
        }
        ++tree.rays;
        const RayHit hit =
            frame.caster.cast(tree.branch.origin, tree.branch.direction, tree.branch.skip);
        if (hit.surface < 0) {
            (void)transport::escape(tree);
            continue;
        }
        const transport::SurfaceHit surface =
            frame.surfaces.at(hit, tree.branch.origin, tree.branch.direction);
        const transport::Encounter met = transport::encounter(tree.branch, surface);
        most = std::max(most, tree.branch.depth + 1);
        (void)transport::scatter(tree, surface, met, frame.surfaces.medium(met.from),
                                 frame.surfaces.medium(met.to), settings);
    }
    return most;
}

glm::vec3 layerValue(const Frame& frame, AovLayer layer, const transport::Branch& ray,
                     const RayHit& hit) {
    if (hit.surface < 0) return glm::vec3(0.0f);
    switch (layer) {
        case AovLayer::depth:
            return glm::vec3(hit.distance);
        case AovLayer::normal:
            return transport::facingSurface(frame.surfaces.at(hit, ray.origin, ray.direction),
                                            ray.direction)
                .n;
        case AovLayer::material:
            return glm::vec3(static_cast<float>(hit.surface + 1));
        case AovLayer::bounces:
            return glm::vec3(static_cast<float>(bouncesAlong(frame, ray)));
    }
    return glm::vec3(0.0f);
}

}  // namespace

std::vector<ImageLayer> traceLayers(const Frame& frame, std::span<const AovLayer> layers) {
    std::vector<ImageLayer> pictures;
    for (const AovLayer layer : layers) {
        pictures.push_back({nameOf(layer), Image(frame.width, frame.height)});
    }
    if (layers.empty()) return pictures;
    parallelFor(0, frame.height, 4, [&](int begin, int end) {
        for (int row = begin; row < end; ++row) {
            for (int column = 0; column < frame.width; ++column) {
                transport::Branch ray;
                ray.origin = frame.camera.eye;
                ray.direction = glm::normalize(frame.camera.direction(
                    static_cast<float>(column) + 0.5f, static_cast<float>(row) + 0.5f));
                ray.throughput = glm::vec3(1.0f);
                ray.footprint = transport::thinFootprint();
                ray.media = frame.eyeMedia;
                ray.skip = -1;
                ray.depth = 0;
                const RayHit hit = frame.caster.cast(ray.origin, ray.direction, -1);
                for (std::size_t i = 0; i < layers.size(); ++i) {
                    pictures[i].image.at(column, row) = layerValue(frame, layers[i], ray, hit);
                }
            }
        }
    });
    return pictures;
}

}  // namespace tukor::trace
