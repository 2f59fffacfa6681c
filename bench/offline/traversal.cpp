// The limit, for offline.py: how long Embree alone takes for the rays that trace casts, one thread.
//
// usage: traversal WIDTHxHEIGHT SAMPLES EYE_Z FOV_DEGREES MODEL... --material 'PATTERN=NAME'...
//                  [--triangles]
//
// --triangles: spheres, too, are cast as the triangles they are made of; trace knows their form.
//
// Traces the picture, keeps every packet that is cast, and then casts them again with nothing
// between. Prints the number of rays, and CPU seconds for building Embree's tree and for casting.
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
#include "tukor/trace/passes.h"

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
    RayCaster caster(surfaces);
    const double built = cpuSeconds();

    std::vector<Packet> packets;
    caster.watch([&](const RayPacket& rays, int count, Coherence coherence) {
        packets.push_back({rays, count, coherence});
    });
    const EnvironmentMap black(CubeMap(1), 0.0f, 1.0f);
    const Frame frame{.surfaces = surfaces,
                      .caster = caster,
                      .environment = black,
                      .camera = RayGenerator(eye, options.width, options.height),
                      .settings = transportSettings(options),
                      .eyeMedia = 0,
                      .background = true,
                      .width = options.width,
                      .height = options.height,
                      .seed = options.seed,
                      .splitGrazing = options.splitGrazing};
    const RenderProgress nobody;
    Passes passes(frame, {.samples = samples, .error = {}, .timeSeconds = {}}, nobody);
    passes.run();
    caster.watch({});

    std::size_t rays = 0;
    const double before = cpuSeconds();
    for (const Packet& packet : packets) {
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
