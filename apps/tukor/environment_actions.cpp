// Captured light converted, filtered and measured.
#include "environment_actions.h"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "interrupt.h"
#include "messages.h"
#include "progress_bar.h"
#include "tukor/base/error.h"
#include "tukor/base/file.h"
#include "tukor/environment/brdf_table.h"
#include "tukor/environment/environment_info.h"
#include "tukor/environment/panorama.h"
#include "tukor/environment/sun.h"
#include "tukor/environment/texture_chain.h"

namespace tukor {
namespace {

/// Shows how far work is on a terminal and hears the first Ctrl-C, while it lives.
class Watch {
public:
    [[nodiscard]] Progress progress() {
        return [this](float fraction) {
            bar_.show(fraction);
            return !InterruptWatch::interrupted();
        };
    }

private:
    InterruptWatch interrupt_;
    ProgressBar bar_{ProgressBar::Loudness::terminal};
};

int stopped() {
    fmt::print(stderr, "tukor: stopped; nothing was written\n");
    return kExitInterrupted;
}

SaveOptions saveOptions(const DevelopOptions& develop) {
    return {.tonemap = develop.tonemap,
            .exposureStops = develop.exposureStops,
            .pngDepth = develop.pngDepth,
            .jpegQuality = develop.jpegQuality,
            .exrPixels = develop.exrPixels,
            .metadata = {}};
}

WorkSource readSource(const SourceArguments& arguments) {
    if (!arguments.sun.empty()) requireWritable(arguments.sun);
    WorkSource source = loadWorkSource(arguments.in, arguments.layout.inLayout, arguments.from);
    for (const std::string& warning : source.warnings)
        warn(fmt::format("{}: {}", arguments.in, warning));
    turn(source, static_cast<double>(arguments.rotateDegrees) * std::numbers::pi / 180.0);
    if (!arguments.sun.empty()) {
        const Image& panorama = panoramaOf(source);
        const std::optional<Sun> sun = findSun(panorama);
        if (!sun)
            throw Error(
                fmt::format("{}: no sun found; nothing is small, alone and ten times brighter "
                            "than what surrounds it",
                            arguments.in));
        writeFile(arguments.sun, jsonOf(*sun));
        source.panorama = withoutSun(panorama, *sun);
        source.cube.reset();
    }
    return source;
}

/// `chain.exr` and 2 give `chain_2.exr`; `chain_{}.exr` gives `chain_2_{}.exr`.
std::string levelPath(const std::string& out, std::size_t level) {
    const auto hole = out.find("{}");
    const auto dot = hole != std::string::npos ? hole : out.rfind('.');
    return fmt::format("{}{}{}{}", out.substr(0, dot), hole != std::string::npos ? "" : "_", level,
                       hole != std::string::npos ? "_" + out.substr(dot) : out.substr(dot));
}

/// The layout asked for, or what the name of the file suggests.
PictureForm formOf(const TargetArguments& to, PictureForm otherwise) {
    const bool faces = to.out.find("{}") != std::string::npos || hasTextureExtension(to.out);
    return to.layout.value_or(faces ? PictureForm::faces : otherwise);
}

WorkTarget workTarget(const TargetArguments& to, PictureForm form, const DevelopOptions& develop) {
    WorkTarget target{.form = form,
                      .size = to.size,
                      .to = to.to,
                      .picture = saveOptions(develop),
                      .texture = {TexelFormat::rgba16f, to.compression}};
    if (!to.format) return target;
    const TexelFormat format = *to.format;
    if (hasTextureExtension(to.out))
        target.texture.texels = format;
    else if (lowerExtension(to.out) != ".exr")
        throw Error(fmt::format(
            "{}: --format is of .exr, .dds, .ktx and .ktx2; others have one, or options of their "
            "own: --png-depth, --jpeg-quality",
            to.out));
    else if (format == TexelFormat::rgba32f || format == TexelFormat::rgba16f)
        target.picture.exrPixels =
            format == TexelFormat::rgba16f ? ExrPixels::half : ExrPixels::full;
    else
        throw Error(fmt::format("{}: --format of .exr is float or half", to.out));
    return target;
}

int saveHarmonics(const SourceArguments& from, const std::string& out,
                  const FilterArguments& arguments) {
    const std::string extension = lowerExtension(out);
    if (extension != ".json" && extension != ".h")
        throw Error(fmt::format("{}: spherical harmonics are written to .json or .h", out));
    const Image panorama = panoramaOf(readSource(from));
    Harmonics harmonics;
    {
        Watch watch;
        const Progress progress = watch.progress();
        progress(0.0f);
        harmonics =
            harmonicsOf(spectrumOf(panorama, std::max(arguments.bands - 1, 8)), arguments.bands);
    }
    if (InterruptWatch::interrupted()) return stopped();
    harmonics = windowed(std::move(harmonics), arguments.window);
    const bool irradiance = arguments.quantity == Quantity::irradiance;
    if (irradiance) harmonics = irradianceOf(std::move(harmonics));
    const char* quantity = irradiance ? "irradiance" : "radiance";
    writeFile(out, extension == ".json" ? jsonOf(harmonics, quantity)
                                        : cHeaderOf(harmonics, quantity, "environmentHarmonics"));
    return 0;
}

/// The levels of a chain, or the one blurred map; none where it was stopped.
std::vector<CubeMap> filteredLevels(const Image& panorama, const FilterArguments& arguments,
                                    std::optional<int> size) {
    Watch watch;
    if (arguments.kind == FilterKind::ggx || arguments.kind == FilterKind::charlie)
        return prefilteredChain(panorama,
                                {.faceSize = size.value_or(256),
                                 .levels = arguments.levels,
                                 .shape = arguments.kind == FilterKind::ggx ? LobeShape::ggx
                                                                            : LobeShape::charlie,
                                 .scale = arguments.scale},
                                watch.progress())
            .levels;
    const bool blur = arguments.kind == FilterKind::blur;
    const double deviation = static_cast<double>(arguments.blurDegrees) * std::numbers::pi / 180.0;
    std::optional<CubeMap> cube = blurredCube(
        panorama, blur ? Lobe{LobeShape::gaussian, deviation} : Lobe{LobeShape::lambert, 1.0},
        size.value_or(blur ? 256 : 32), watch.progress());
    std::vector<CubeMap> levels;
    if (cube) levels.push_back(std::move(*cube));
    return levels;
}

}  // namespace

int convertEnvironment(const SourceArguments& from, const TargetArguments& to,
                       const DevelopOptions& develop) {
    const PictureForm form = formOf(to, PictureForm::equirect);
    checkWorkTarget(to.out, form);
    requireWritable(to.out);
    WorkSource source = readSource(from);
    bool saved = false;
    {
        Watch watch;
        saved =
            saveWork(to.out, std::move(source), workTarget(to, form, develop), watch.progress());
    }
    return saved ? 0 : stopped();
}

int filterEnvironment(const SourceArguments& from, const TargetArguments& to,
                      const FilterArguments& arguments, const DevelopOptions& develop) {
    if (arguments.kind == FilterKind::brdf) {
        checkSavable(to.out);
        saveImage(to.out, brdfTable(to.size.value_or(128)), saveOptions(develop));
        return 0;
    }
    if (from.in.empty()) throw Error("IN is missing: the environment to filter");
    requireWritable(to.out);
    if (arguments.kind == FilterKind::sh) return saveHarmonics(from, to.out, arguments);

    const PictureForm form = formOf(to, PictureForm::hcross);
    checkWorkTarget(to.out, form);
    const bool chain = arguments.kind == FilterKind::ggx || arguments.kind == FilterKind::charlie;
    const int size = to.size.value_or(256);
    if (chain && size >> (arguments.levels - 1) < 1)
        throw Error(fmt::format("{} levels from faces of {} texels; expected at most {}",
                                arguments.levels, size, static_cast<int>(std::log2(size)) + 1));
    std::vector<CubeMap> levels = filteredLevels(panoramaOf(readSource(from)), arguments, to.size);
    if (levels.empty()) return stopped();
    WorkTarget target = workTarget(to, form, develop);
    if (chain && hasTextureExtension(to.out)) {
        saveLevels(to.out, levels, target);
        return 0;
    }
    target.size = std::nullopt;
    for (std::size_t level = 0; level < levels.size(); ++level) {
        WorkSource result;
        result.cube = std::move(levels[level]);
        saveWork(chain ? levelPath(to.out, level) : to.out, std::move(result), target);
    }
    return 0;
}

int describeEnvironment(const SourceArguments& from, const std::string& thumbnail) {
    if (!thumbnail.empty()) {
        checkSavable(thumbnail);
        requireWritable(thumbnail);
    }
    const WorkSource source = loadWorkSource(from.in, from.layout.inLayout);
    fmt::print("{}", describeWork(source));
    if (!thumbnail.empty()) saveImage(thumbnail, contactSheet(source));
    return 0;
}

}  // namespace tukor
