#include "tukor/trace/render.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/environment/panorama.h"
#include "tukor/environment/prefilter.h"
#include "tukor/trace/layers.h"
#include "tukor/trace/passes.h"
#include "tukor/trace/rough_event.h"
#include "tukor/trace/silhouette.h"

namespace tukor::trace {

namespace {

constexpr std::uint32_t kUsualSamples = 64;
constexpr std::uint32_t kMostSamples = 1u << 20;  // float sums of more would stop growing

void check(const RenderOptions& options) {
    const auto pixels = static_cast<std::int64_t>(options.width) * options.height;
    if (options.width < 1 || options.height < 1 || pixels > (std::int64_t{1} << 30)) {
        throw Error(fmt::format("{} x {} pixels; a picture has at least 1 and at most 2^30",
                                options.width, options.height));
    }
}

PassGoals goalsOf(const RenderOptions& options) {
    PassGoals goals{};
    if (options.samples) {
        goals.samples = static_cast<std::uint32_t>(
            std::clamp(*options.samples, 1, static_cast<int>(kMostSamples)));
    } else {
        goals.samples = options.error || options.timeSeconds ? kMostSamples : kUsualSamples;
    }
    if (options.error) goals.error = *options.error;
    if (options.timeSeconds) goals.timeSeconds = *options.timeSeconds;
    goals.beyondWhite = options.beyondWhite;
    if (!options.samples && !options.error && !options.timeSeconds) goals.error = 1.0;
    return goals;
}

/// Drawing a triangle takes about as long as casting a ray or less; a pixel of the sky saves some.
bool paysToRasterize(const SurfaceTable& surfaces, const RenderOptions& options) {
    std::size_t triangles = 0;
    for (const SurfaceTable::Entry& entry : surfaces.entries()) triangles += entry.indices.size();
    return triangles <=
           2 * static_cast<std::size_t>(options.width) * static_cast<std::size_t>(options.height);
}

EnvironmentMap blurredMap(const Image& panorama, const RenderOptions& options) {
    return {blurredBackdrop(panorama, options.backgroundBlur), options.environmentRotation,
            options.environmentIntensity};
}

/// `backdrop`: what is seen beside the scene; null: `map`.
Rendering renderUnder(const EnvironmentMap& map, const EnvironmentMap* backdrop, const Scene& given,
                      const Camera& camera, const RenderOptions& options,
                      const RenderProgress& progress) {
    std::optional<Scene> grounded;
    if (options.ground) grounded = withGround(given, *options.ground);
    const Scene& scene = grounded ? *grounded : given;
    const SurfaceTable surfaces(scene);
    const RayCaster caster(surfaces);
    const bool finished = std::any_of(scene.parts.begin(), scene.parts.end(), [](const Part& part) {
        return part.material.finish != nullptr;
    });
    std::optional<RoughEvent> rough;
    if (finished)
        rough.emplace(scene, surfaces, caster, map,
                      options.background == Background::none ? nullptr
                      : backdrop                             ? backdrop
                                                             : &map,
                      static_cast<float>(options.samples.value_or(32)));
    const PassGoals goals = goalsOf(options);
    std::optional<optics::Spectrum> spectrum;  // a single sample would have a single colour
    if (surfaces.disperse() && goals.samples > 1) spectrum = optics::visibleSpectrum();
    Frame frame{
        .surfaces = surfaces,
        .caster = caster,
        .environment = map,
        .camera = RayGenerator(camera, options.width, options.height),
        .settings = transportSettings(options),
        .eyeMedia = mediaAround(camera.eye, surfaces, caster),
        .background = options.background != Background::none,
        .width = options.width,
        .height = options.height,
        .seed = options.seed,
        .splitGrazing = options.splitGrazing && !goals.error && !goals.timeSeconds,
        .retakeFaulty = options.retakeFaulty,
        .rough = rough ? &*rough : nullptr,
        .spectrum = spectrum ? &*spectrum : nullptr,
        .backdrop = backdrop,
    };
    std::vector<std::uint8_t> silhouette;
    if (!frame.camera.hasLens() && paysToRasterize(surfaces, options)) {
        silhouette = silhouetteOf(surfaces, frame.camera, frame.width, frame.height);
        frame.silhouette = silhouette;
    }
    Passes passes(frame, goals, progress);
    passes.run();

    const Accumulation& picture = passes.picture();
    Rendering rendering;
    rendering.radiance = Image(options.width, options.height);
    if (!frame.background) rendering.radiance.alpha.resize(picture.samples.size());
    double samples = 0.0;
    for (std::size_t i = 0; i < picture.samples.size(); ++i) {
        // Shadows are subtracted: where they are black noise may be below.
        rendering.radiance.pixels()[i] = glm::max(picture.mean(i), glm::vec3(0.0f));
        samples += picture.samples[i];
        if (!frame.background && picture.samples[i] > 0) {
            rendering.radiance.alpha[i] =
                picture.sums[i].coverage / static_cast<float>(picture.samples[i]);
        }
    }
    const TraceCounts counts = passes.counts();
    rendering.rays = counts.rays;
    rendering.leaks = counts.leaks;
    rendering.inconsistencies = counts.inconsistencies;
    rendering.truncated = counts.truncated;
    rendering.samplesPerPixel = samples / static_cast<double>(picture.samples.size());
    rendering.error = passes.estimate().rmse();
    rendering.noise = passes.estimate().noise();
    rendering.layers = traceLayers(frame, options.layers);
    return rendering;
}

}  // namespace

Rendering render(const Scene& scene, const CubeMap& environment, const Camera& camera,
                 const RenderOptions& options, const RenderProgress& progress) {
    check(options);
    const EnvironmentMap map(environment, options.environmentRotation,
                             options.environmentIntensity);
    std::optional<EnvironmentMap> backdrop;
    if (blursBackground(options))
        backdrop.emplace(
            blurredMap(panoramaFromCube(environment, 4 * environment.faceSize()), options));
    return renderUnder(map, backdrop ? &*backdrop : nullptr, scene, camera, options, progress);
}

Rendering render(const Scene& scene, const Image& panorama, const Camera& camera,
                 const RenderOptions& options, const RenderProgress& progress) {
    check(options);
    const EnvironmentMap map(panorama, options.environmentRotation, options.environmentIntensity);
    std::optional<EnvironmentMap> backdrop;
    if (blursBackground(options)) backdrop.emplace(blurredMap(panorama, options));
    return renderUnder(map, backdrop ? &*backdrop : nullptr, scene, camera, options, progress);
}

Rendering render(const Scene& scene, const Environment& environment, const Camera& camera,
                 const RenderOptions& options, const RenderProgress& progress) {
    return environment.panorama ? render(scene, *environment.panorama, camera, options, progress)
                                : render(scene, environment.radiance, camera, options, progress);
}

}  // namespace tukor::trace
