#include "tukor/app/picture.h"

#include <algorithm>
#include <cerrno>
#include <string_view>

#include <fmt/format.h>

#include "tukor/app/option_table.h"
#include "tukor/app/version.h"
#include "tukor/base/error.h"
#include "tukor/base/file.h"
#include "tukor/image/image_file.h"
#if TUKOR_GL
#include "tukor/gl/render.h"
#endif
#if TUKOR_TRACE
#include "tukor/trace/render.h"
#endif

namespace tukor {
namespace {

/// The first option that gl does not know what to do with; empty when there is none.
std::string_view onlyForTrace(const QualityOptions& quality) {
    if (quality.error) return "error";
    if (quality.seconds) return "time";
    if (!quality.layers.empty()) return "aov";
    return {};
}

}  // namespace

Renderer rendererFor(const SessionOptions& options) noexcept {
    if (options.quality.renderer) return *options.quality.renderer;
    return TUKOR_TRACE ? Renderer::trace : Renderer::gl;
}

void requireWritablePicture(const std::filesystem::path& out, const SessionOptions& options) {
    checkSavable(out);
    if (!options.quality.layers.empty() && lowerExtension(out) != ".exr") {
        throw Error(fmt::format("{}: only .exr holds the layers of --aov", out.string()));
    }
    requireWritable(out);
}

std::filesystem::path freshPicturePath(const std::filesystem::path& folder) {
    for (int i = 1; i < 10000; ++i) {
        std::filesystem::path path = folder / fmt::format("tukor-{:04}.png", i);
        std::error_code ignored;
        if (!std::filesystem::exists(std::filesystem::symlink_status(path, ignored))) return path;
    }
    throw Error(fmt::format("{}: 9999 pictures are here already; move some away", folder.string()));
}

Rendering renderPicture(const Session& session, const RenderProgress& progress) {
    const RenderOptions options = session.renderOptions();
    if (rendererFor(session.options()) == Renderer::gl) {
        const std::string_view needsTrace = onlyForTrace(session.options().quality);
        if (!needsTrace.empty()) {
            throw Error(fmt::format("--{} is for the renderer trace, not for gl", needsTrace));
        }
#if TUKOR_GL
        return gl::render(session.scene(), session.environment(), session.camera(), options,
                          progress);
#else
        throw Error("this build has no renderer gl; configure with -DTUKOR_GL=ON");
#endif
    }
#if TUKOR_TRACE
    return trace::render(session.scene(), session.environment(), session.camera(), options,
                         progress);
#else
    throw Error("this build has no renderer trace; configure with -DTUKOR_TRACE=ON");
#endif
}

void savePicture(const std::filesystem::path& out, const Rendering& rendering,
                 const Session& session) {
    const DevelopOptions& develop = session.options().develop;
    SaveOptions save;
    save.tonemap = develop.tonemap;
    save.exposureStops = develop.exposureStops;
    save.pngDepth = develop.pngDepth;
    save.jpegQuality = develop.jpegQuality;
    save.exrPixels = develop.exrPixels;
    save.metadata = {
        {"Software", "tukor " + versionText()},
        {"command", commandLine("tukor render", session.options())},
        {"options", jsonFromOptions(session.options())},
    };
    if (rendering.rays > 0) save.metadata.push_back({"rays", fmt::format("{}", rendering.rays)});
    const std::uint64_t faults = rendering.leaks + rendering.inconsistencies;
    if (faults > 0) save.metadata.push_back({"faulty-rays", fmt::format("{}", faults)});
    if (rendering.samplesPerPixel > 0.0) {
        save.metadata.push_back({"samples", fmt::format("{:.3f}", rendering.samplesPerPixel)});
    }
    if (rendering.error) {
        save.metadata.push_back({"expected-rmse", fmt::format("{:.4f}", *rendering.error)});
    }
    if (rendering.noise) {
        save.metadata.push_back({"expected-noise", fmt::format("{:.4f}", *rendering.noise)});
    }
    if (rendering.layers.empty()) {
        saveImage(out, rendering.radiance, save);
        return;
    }
    std::vector<ImageLayer> layers = rendering.layers;
    layers.insert(layers.begin(), {"", rendering.radiance});
    saveExrLayers(out, layers, save);
}

std::vector<std::string> warningsOf(const Rendering& rendering) {
    const std::uint64_t faults = rendering.leaks + rendering.inconsistencies;
    // Fewer than one ray in ten million is single precision at work, not a hole that could be
    // closed.
    if (faults == 0 || faults < rendering.rays / 10'000'000) return {};
    return {
        fmt::format("{} of {} rays left a solid without crossing its surface or met it from the "
                    "wrong side: close the holes of the model and let its triangles face "
                    "outwards, or render it with --fidelity single",
                    faults, rendering.rays)};
}

std::string summaryOf(const Rendering& rendering, double seconds) {
    std::string text = fmt::format("{:.1f} s", seconds);
    if (rendering.samplesPerPixel > 0.0) {
        text += fmt::format(", {:.1f} samples a pixel", rendering.samplesPerPixel);
    }
    if (rendering.rays > 0) {
        const auto rays = static_cast<double>(rendering.rays);
        text += fmt::format(", {:.1f} million rays ({:.1f} million a second)", rays / 1e6,
                            rays / 1e6 / std::max(seconds, 1e-3));
    }
    if (rendering.error) text += fmt::format(", expected RMSE {:.2f}", *rendering.error);
    if (rendering.noise && *rendering.noise < 0.9 * rendering.error.value_or(0.0))
        text += fmt::format(" (noise {:.2f}, the rest suns and lamps that glint in glass)",
                            *rendering.noise);
    return text;
}

}  // namespace tukor
