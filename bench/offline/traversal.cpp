// The limit, for offline.py: how long Embree alone takes for the rays that trace casts, one thread.
//
// usage: traversal WIDTHxHEIGHT SAMPLES EYE_Z FOV_DEGREES MODEL... --material 'PATTERN=NAME'...
//                  [--triangles]
//
// --triangles: spheres, too, are cast as the triangles they are made of; trace knows their form.
//
// Follows the tree of every camera ray as trace does, 64 at a time, keeps the rays in the order and
// the packets in which trace would cast them, and then casts them again with nothing between.
// Prints the number of rays, and CPU seconds for building Embree's tree and for casting.
#include <array>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <exception>
#include <numbers>
#include <string>
#include <vector>

#include "tukor/base/parallel.h"
#include "tukor/scene/assign_materials.h"
#include "tukor/scene/model_file.h"
#include "tukor/trace/frame.h"
#include "tukor/transport/sampler.h"

namespace {

using namespace tukor;
using namespace tukor::trace;

double cpuSeconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

struct Packet {
    RayPacket rays;
    int count;
    Coherence coherence;
};

class Recorder {
public:
    Recorder(const SurfaceTable& surfaces, const RayCaster& caster,
             transport::TransportSettings settings)
        : surfaces_(surfaces), caster_(caster), settings_(settings) {}

    /// The trees of these camera rays, in step.
    void follow(std::vector<transport::Tree>& trees) {
        Coherence coherence = Coherence::rays;
        while (!trees.empty()) {
            for (std::size_t begin = 0; begin < trees.size(); begin += kPacketWidth) {
                cast(&trees[begin],
                     static_cast<int>(std::min<std::size_t>(kPacketWidth, trees.size() - begin)),
                     coherence);
            }
            coherence = Coherence::none;
            std::erase_if(trees, [&](transport::Tree& tree) {
                while (tree.alive && transport::spent(tree, settings_)) {
                    (void)transport::cutBranch(tree);
                }
                return !tree.alive;
            });
        }
    }

    [[nodiscard]] const std::vector<Packet>& packets() const { return packets_; }

private:
    void cast(transport::Tree* trees, int count, Coherence coherence) {
        Packet& packet = packets_.emplace_back();
        packet.count = count;
        packet.coherence = coherence;
        for (int i = 0; i < count; ++i) {
            packet.rays.set(i, trees[i].branch.origin, trees[i].branch.direction,
                            trees[i].branch.skip);
            ++trees[i].rays;
        }
        std::array<RayHit, kPacketWidth> hits;
        caster_.cast(packet.rays, count, coherence, hits);
        for (int i = 0; i < count; ++i) {
            const RayHit& hit = hits[static_cast<std::size_t>(i)];
            if (hit.surface < 0) {
                (void)transport::escape(trees[i]);
                continue;
            }
            const transport::SurfaceHit surface =
                surfaces_.at(hit, trees[i].branch.origin, trees[i].branch.direction);
            const transport::Encounter met = transport::encounter(trees[i].branch, surface);
            (void)transport::scatter(trees[i], surface, met, surfaces_.medium(met.from),
                                     surfaces_.medium(met.to), settings_);
        }
    }

    const SurfaceTable& surfaces_;
    const RayCaster& caster_;
    transport::TransportSettings settings_;
    std::vector<Packet> packets_;
};

transport::Tree treeAt(const RayGenerator& camera, glm::vec2 at, std::uint32_t seed,
                       std::uint32_t index) {
    transport::Branch ray{};
    ray.origin = camera.eye;
    ray.direction = glm::normalize(camera.direction(at.x, at.y));
    ray.throughput = glm::vec3(1.0f);
    ray.footprint = transport::thinFootprint();
    ray.skip = -1;
    return transport::startTree(ray, seed, index);
}

SurfaceTable trianglesOf(const Scene& scene) {
    const MediaTable table = mediaOf(scene);
    std::vector<Surface> surfaces;
    for (std::size_t i = 0; i < scene.parts.size(); ++i) {
        const int medium = table.mediumOfPart[i];
        surfaces.push_back(
            {&scene.parts[i].mesh, scene.parts[i].material, medium < 0 ? 0u : 1u << medium});
    }
    return {surfaces, table.media};
}

int run(int argc, char** argv) {
    RenderOptions options;
    if (std::sscanf(argv[1], "%dx%d", &options.width, &options.height) != 2) {
        std::fprintf(stderr, "%s: a size as 480x270 expected\n", argv[1]);
        return 2;
    }
    const auto samples = static_cast<std::uint32_t>(std::stoi(argv[2]));
    Camera eye;
    eye.eye = {0.0f, 0.0f, std::stof(argv[3])};
    eye.target = glm::vec3(0.0f);
    eye.verticalFov = std::stof(argv[4]) * std::numbers::pi_v<float> / 180.0f;
    Scene scene;
    std::vector<std::string> materials;
    bool triangles = false;
    for (int i = 5; i < argc; ++i) {
        if (std::strcmp(argv[i], "--material") == 0 && i + 1 < argc) {
            materials.emplace_back(argv[++i]);
        } else if (std::strcmp(argv[i], "--triangles") == 0) {
            triangles = true;
        } else {
            append(scene, loadModel(argv[i]));
        }
    }
    assignMaterials(scene, materials);
    setThreadCount(1);

    const double begin = cpuSeconds();
    const SurfaceTable surfaces = triangles ? trianglesOf(scene) : SurfaceTable(scene);
    const RayCaster caster(surfaces);
    const double built = cpuSeconds();
    const RayGenerator camera(eye, options.width, options.height);
    Recorder recorder(surfaces, caster, transportSettings(options));
    std::vector<transport::Tree> trees;
    for (int pixel = 0; pixel < options.width * options.height; ++pixel) {
        const std::uint32_t seed = transport::mixedBits(static_cast<std::uint32_t>(pixel));
        for (std::uint32_t s = 0; s < samples; ++s) {
            const glm::vec2 place = transport::pixelSample(seed, s) +
                                    glm::vec2(pixel % options.width, pixel / options.width);
            trees.push_back(treeAt(camera, place, seed, s));
            if (trees.size() == 64) recorder.follow(trees);
        }
    }
    recorder.follow(trees);

    std::size_t rays = 0;
    const double before = cpuSeconds();
    for (const Packet& packet : recorder.packets()) {
        std::array<RayHit, kPacketWidth> hits;
        caster.cast(packet.rays, packet.count, packet.coherence, hits);
        rays += static_cast<std::size_t>(packet.count);
    }
    const double after = cpuSeconds();
    std::printf("%zu %.4f %.4f\n", rays, built - begin, after - before);
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        if (argc < 6) {
            std::fprintf(stderr, "usage: traversal WIDTHxHEIGHT SAMPLES EYE_Z FOV MODEL...\n");
            return 2;
        }
        return run(argc, argv);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "traversal: %s\n", error.what());
        return 1;
    }
}
