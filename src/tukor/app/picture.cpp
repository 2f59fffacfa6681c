#include "tukor/app/picture.h"

#include <algorithm>
#include <cerrno>
#include <string_view>

#include <fmt/format.h>

#include "tukor/app/option_table.h"
#include "tukor/app/version.h"
#include "tukor/base/error.h"
#include "tukor/base/file.h"
#include "tukor/environment/clipping.h"
#include "tukor/image/image_file.h"
#if TUKOR_GL
#include "tukor/gl/render.h"
#endif
#if TUKOR_TRACE
#include "tukor/trace/render.h"
#endif

namespace tukor {
namespace {

/// The options that gl does not know what to do with.
std::vector<std::string_view> onlyForTrace(const QualityOptions& quality) {
    std::vector<std::string_view> names;
    if (quality.error) names.emplace_back("error");
    if (quality.seconds) names.emplace_back("time");
    if (!quality.layers.empty()) names.emplace_back("aov");
    return names;
}

bool holdsRadiance(const std::filesystem::path& out) {
    const std::string extension = lowerExtension(out);
    return extension == ".exr" || extension == ".hdr";
}

/// Where a picture ends far above the error that it was to have; empty where it does not.
std::string missedError(const Rendering& rendering, const QualityOptions& quality) {
    constexpr double kUsual = 1.0;     // that of pictures for which nothing is said
    constexpr double kFarAbove = 1.5;  // what is reported is within that factor of the truth
    const bool limited = quality.seconds || (quality.samples && !quality.error);
    const double aim = quality.error ? double(*quality.error) : kUsual;
    if (limited || !rendering.error || *rendering.error <= kFarAbove * aim) return {};
    std::string text = fmt::format("expected RMSE {:.1f} after {:.0f} samples a pixel, ",
                                   *rendering.error, rendering.samplesPerPixel);
    if (!quality.error) return text + "1 is usual: --error 1 goes on, --samples N says how far";
    text += fmt::format("{} was asked", *quality.error);
    return quality.samples ? text + ": a larger --samples goes on" : text;
}

}  // namespace

Renderer rendererFor(const SessionOptions& options) noexcept {
    if (options.quality.renderer) return *options.quality.renderer;
    return TUKOR_TRACE ? Renderer::trace : Renderer::gl;
}

SessionOptions windowOptions(SessionOptions options) {
    options.quality.renderer = Renderer::gl;
    options.quality.error.reset();
    options.quality.seconds.reset();
    options.quality.layers.clear();
    return options;
}

std::vector<std::string> unusedInWindow(const SessionOptions& options) {
    std::vector<std::string> all;
    if (options.quality.renderer == Renderer::trace)
        all.emplace_back("--renderer trace: the window draws by gl");
    for (const std::string_view name : onlyForTrace(options.quality)) {
        all.push_back(fmt::format("--{} is for the renderer trace; the window draws by gl", name));
    }
    return all;
}

void requireWritablePicture(const std::filesystem::path& out, const SessionOptions& options) {
    checkSavable(out);
    if (!options.quality.layers.empty() && lowerExtension(out) != ".exr") {
        throw Error(fmt::format("{}: only .exr holds the layers of --aov", out.string()));
    }
    requireWritable(out);
}

std::vector<std::string> unusedInFile(const std::filesystem::path& out,
                                      const SessionOptions& options) {
    const std::string extension = lowerExtension(out);
    const bool jpeg = extension == ".jpg" || extension == ".jpeg";
    const bool radiance = holdsRadiance(out);
    std::vector<std::string> all;
    const DevelopOptions usual;
    const DevelopOptions& develop = options.develop;
    const auto check = [&](bool unused, std::string_view option, std::string_view why) {
        if (unused) all.push_back(fmt::format("{}: --{} {}", out.string(), option, why));
    };
    check(options.light.background == Background::none && (jpeg || extension == ".hdr"),
          "background none", "is black here; .png and .exr hold what is clear");
    check(develop.exposureStops != usual.exposureStops && radiance, "exposure",
          "is for .png and .jpg; .exr and .hdr keep radiance");
    check(develop.tonemap != usual.tonemap && radiance, "tonemap",
          "is for .png and .jpg; .exr and .hdr keep radiance");
    check(develop.pngDepth != usual.pngDepth && extension != ".png", "png-depth", "is for .png");
    check(develop.jpegQuality != usual.jpegQuality && !jpeg, "jpeg-quality", "is for .jpg");
    check(develop.exrPixels != usual.exrPixels && extension != ".exr", "exr-pixels", "is for .exr");
    return all;
}

std::filesystem::path freshPicturePath(const std::filesystem::path& folder) {
    for (int i = 1; i < 10000; ++i) {
        std::filesystem::path path = folder / fmt::format("tukor-{:04}.png", i);
        std::error_code ignored;
        if (!std::filesystem::exists(std::filesystem::symlink_status(path, ignored))) return path;
    }
    throw Error(fmt::format("{}: 9999 pictures are here already; move some away", folder.string()));
}

bool showsBeyondWhite(const std::filesystem::path& out, const SessionOptions& options) {
    const Tonemap tonemap = options.develop.tonemap;
    // To neutral it is the last 14 codes.
    const bool whiteIsWhite = tonemap == Tonemap::none || tonemap == Tonemap::neutral;
    return holdsRadiance(out) || options.develop.exposureStops < 0.0f || !whiteIsWhite;
}

Rendering renderPicture(const Session& session, const RenderProgress& progress, bool beyondWhite) {
    RenderOptions options = session.renderOptions();
    options.beyondWhite = beyondWhite;
    if (rendererFor(session.options()) == Renderer::gl) {
        const auto needTrace = onlyForTrace(session.options().quality);
        if (!needTrace.empty()) {
            throw Error(
                fmt::format("--{} is for the renderer trace, not for gl", needTrace.front()));
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
                 const SessionOptions& options) {
    const DevelopOptions& develop = options.develop;
    SaveOptions save;
    save.tonemap = develop.tonemap;
    save.exposureStops = develop.exposureStops;
    save.pngDepth = develop.pngDepth;
    save.jpegQuality = develop.jpegQuality;
    save.exrPixels = develop.exrPixels;
    save.metadata = {
        {"Software", "tukor " + versionText()},
        {"command", commandLine("tukor render", options)},
        {"options", jsonFromOptions(options)},
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

std::vector<std::string> warningsOf(const Rendering& rendering, const Session& session) {
    std::vector<std::string> all;
    const auto& parts = session.scene().parts;
    const bool clear = std::any_of(parts.begin(), parts.end(), [](const Part& part) {
        return part.material.kind == MaterialKind::dielectric;
    });
    const std::uint64_t faults = rendering.leaks + rendering.inconsistencies;
    // Nothing goes on inside of opaque parts, holes or not. Fewer than one ray in ten million is
    // single precision at work, not a hole that could be closed.
    if (clear && faults > 0 && faults >= rendering.rays / 10'000'000)
        all.push_back(fmt::format(
            "{} of {} rays left a solid without crossing its surface or met it from the "
            "wrong side: close the holes of the model and let its triangles face "
            "outwards, or render it with --fidelity single",
            faults, rendering.rays));
    if (std::string missed = missedError(rendering, session.options().quality); !missed.empty())
        all.push_back(std::move(missed));
    return all;
}

std::string clippedInFile(const std::filesystem::path& out, const Rendering& rendering,
                          const SessionOptions& options) {
    if (lowerExtension(out) != ".exr" || options.develop.exrPixels != ExrPixels::half) return {};
    Clipping clipping{largestOf(TexelFormat::rgba16f)};
    addClipping(clipping, rendering.radiance, PixelAreas::equal);
    if (clipping.pixels == 0) return {};
    return sentenceOf(clipping, "half") + "; --exr-pixels full keeps it";
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
