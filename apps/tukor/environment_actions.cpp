// Captured light converted, filtered and measured.
#include "environment_actions.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <span>
#include <string_view>

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

bool isChain(FilterKind kind) {
    return kind == FilterKind::ggx || kind == FilterKind::charlie;
}

int stopped() {
    fmt::print(stderr, "tukor: stopped; nothing was written\n");
    return kExitInterrupted;
}

/// Without the exposure, which the source has had: files of radiance want it, too.
SaveOptions saveOptions(const DevelopOptions& develop) {
    return {.tonemap = develop.tonemap,
            .exposureStops = 0.0f,
            .pngDepth = develop.pngDepth,
            .jpegQuality = develop.jpegQuality,
            .exrPixels = develop.exrPixels,
            .metadata = {}};
}

/// What is read, and the file of the sun where one was asked for.
struct Reading {
    WorkSource source;
    std::vector<EncodedFile> sun;
};

Reading readSource(const SourceArguments& arguments, const DevelopOptions& develop) {
    if (!arguments.sun.empty()) requireWritable(arguments.sun);
    Reading reading{loadWorkSource(arguments.in, arguments.layout.inLayout, arguments.from), {}};
    WorkSource& source = reading.source;
    for (const std::string& warning : source.warnings)
        warn(fmt::format("{}: {}", arguments.in, warning));
    expose(source, develop.exposureStops);
    turn(source, static_cast<double>(arguments.rotateDegrees) * std::numbers::pi / 180.0);
    if (!arguments.sun.empty()) {
        const Image& panorama = panoramaOf(source);
        const std::optional<Sun> sun = findSun(panorama);
        if (!sun)
            throw Error(
                fmt::format("{}: no sun found; nothing is small, alone and ten times brighter "
                            "than what surrounds it",
                            arguments.in));
        const std::string text = jsonOf(*sun);
        const auto bytes = std::as_bytes(std::span(text));
        reading.sun.push_back({arguments.sun, {bytes.begin(), bytes.end()}});
        source.panorama = withoutSun(panorama, *sun);
        source.cube.reset();
        source.square.reset();
    }
    return reading;
}

/// `chain.exr` and 2 give `chain_2.exr`; `chain_{}.exr` gives `chain_2_{}.exr`.
std::string levelPath(const std::string& out, std::size_t level) {
    const auto hole = out.find("{}");
    const auto dot = hole != std::string::npos ? hole : out.rfind('.');
    return fmt::format("{}{}{}{}", out.substr(0, dot), hole != std::string::npos ? "" : "_", level,
                       hole != std::string::npos ? "_" + out.substr(dot) : out.substr(dot));
}

/// About what the format cannot hold of the files of one environment.
void warnOfClipping(const SourceArguments& from, const TargetArguments& to,
                    std::span<const EncodedFile> files) {
    Clipping all;
    for (const EncodedFile& file : files) {
        all.most = file.clipping.most;
        all.pixels += file.clipping.pixels;
        all.lost += file.clipping.lost;
        all.whole += file.clipping.whole;
    }
    if (all.pixels == 0) return;
    std::string_view name = "half";
    for (const auto& [format, spelling] : kTexelFormatSpellings)
        if (to.format == format) name = spelling;
    warn(fmt::format("{}: {}; --format float keeps it{}", to.out, sentenceOf(all, name),
                     from.sun.empty() ? ", --sun FILE takes a sun out" : ""));
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
                  const FilterArguments& arguments, const DevelopOptions& develop) {
    const std::string extension = lowerExtension(out);
    if (extension != ".json" && extension != ".h")
        throw Error(fmt::format("{}: spherical harmonics are written to .json or .h", out));
    Reading reading = readSource(from, develop);
    const Image panorama = panoramaOf(std::move(reading.source));
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
    writeFiles(reading.sun);
    writeFile(out, extension == ".json" ? jsonOf(harmonics, quantity)
                                        : cHeaderOf(harmonics, quantity, "environmentHarmonics"));
    return 0;
}

/// The levels of a chain, or the one blurred map; none where it was stopped.
std::vector<CubeMap> filteredLevels(const Image& panorama, const FilterArguments& arguments,
                                    int faceSize, const Progress& progress) {
    if (isChain(arguments.kind))
        return prefilteredChain(panorama,
                                {.faceSize = faceSize,
                                 .levels = arguments.levels,
                                 .shape = arguments.kind == FilterKind::ggx ? LobeShape::ggx
                                                                            : LobeShape::charlie,
                                 .scale = arguments.scale},
                                progress)
            .levels;
    const double deviation = static_cast<double>(arguments.blurDegrees) * std::numbers::pi / 180.0;
    std::optional<CubeMap> cube =
        blurredCube(panorama,
                    arguments.kind == FilterKind::blur ? Lobe{LobeShape::gaussian, deviation}
                                                       : Lobe{LobeShape::lambert, 1.0},
                    faceSize, progress);
    std::vector<CubeMap> levels;
    if (cube) levels.push_back(std::move(*cube));
    return levels;
}

/// Faces with as many texels to the degree as a picture of this size; the default without one.
int filteredFaceSize(const TargetArguments& to, PictureForm form, FilterKind kind) {
    if (!to.size) return kind == FilterKind::irradiance ? 32 : 256;
    if (form == PictureForm::equirect) return std::max(1, *to.size / 4);
    if (form == PictureForm::octahedral || form == PictureForm::ball)
        return std::max(1, *to.size / 2);
    return *to.size;
}

/// The size of a level of a chain; none: that of its faces. Panoramas have even widths.
std::optional<int> levelSize(const TargetArguments& to, PictureForm form, std::size_t level) {
    if (!to.size || level == 0) return to.size;
    const int size = *to.size >> level;
    return form == PictureForm::equirect ? std::max(2, size / 2 * 2) : std::max(1, size);
}

int saveTable(const TargetArguments& to, const DevelopOptions& develop) {
    const std::string extension = lowerExtension(to.out);
    if (extension != ".exr" && extension != ".hdr")
        throw Error(fmt::format(
            "{}: the table is data, which pictures would bend to sRGB; expected .exr or .hdr",
            to.out));
    requireWritable(to.out);
    const WorkTarget target = workTarget(to, PictureForm::equirect, develop);
    Watch watch;
    const Image table = brdfTable(to.size.value_or(128), watch.progress());
    if (table.empty()) return stopped();
    saveImage(to.out, table, target.picture);
    return 0;
}

}  // namespace

int convertEnvironment(const SourceArguments& from, const TargetArguments& to,
                       const DevelopOptions& develop) {
    const PictureForm form = formOf(to, PictureForm::equirect);
    checkWorkTarget(to.out, form);
    requireWritable(to.out);
    Reading reading = readSource(from, develop);
    Watch watch;
    const std::vector<EncodedFile> files = encodeWork(
        to.out, std::move(reading.source), workTarget(to, form, develop), watch.progress());
    if (files.empty()) return stopped();
    writeFiles(reading.sun);
    writeFiles(files);
    warnOfClipping(from, to, files);
    return 0;
}

int filterEnvironment(const SourceArguments& from, const TargetArguments& to,
                      const FilterArguments& arguments, const DevelopOptions& develop) {
    if (arguments.kind == FilterKind::brdf) return saveTable(to, develop);
    if (from.in.empty()) throw Error("IN is missing: the environment to filter");
    requireWritable(to.out);
    if (arguments.kind == FilterKind::sh) return saveHarmonics(from, to.out, arguments, develop);

    const PictureForm form = formOf(to, PictureForm::hcross);
    checkWorkTarget(to.out, form);
    const bool chain = isChain(arguments.kind);
    const int faceSize = filteredFaceSize(to, form, arguments.kind);
    if (chain && faceSize >> (arguments.levels - 1) < 1)
        throw Error(fmt::format("{} levels from faces of {} texels; expected at most {}",
                                arguments.levels, faceSize,
                                static_cast<int>(std::log2(faceSize)) + 1));
    WorkTarget target = workTarget(to, form, develop);
    Reading reading = readSource(from, develop);
    Watch watch;  // until all is written: a chain is there whole or not at all
    const Progress whole = watch.progress();
    std::vector<CubeMap> levels = filteredLevels(panoramaOf(std::move(reading.source)), arguments,
                                                 faceSize, partOf(whole, 0.0f, 0.8f));
    if (levels.empty()) return stopped();
    std::vector<EncodedFile> files;
    const Progress encoding = partOf(whole, 0.8f, 1.0f);
    if (chain && hasTextureExtension(to.out)) {
        files = encodeLevels(to.out, levels, target, encoding);
        if (files.empty()) return stopped();
        warnOfClipping(from, to, files);
    } else {
        for (std::size_t level = 0; level < levels.size(); ++level) {
            WorkSource result;
            result.cube = std::move(levels[level]);
            target.size = levelSize(to, form, level);
            std::vector<EncodedFile> some = encodeWork(chain ? levelPath(to.out, level) : to.out,
                                                       std::move(result), target, encoding);
            if (some.empty()) return stopped();
            // The other levels are means of it.
            if (level == 0) warnOfClipping(from, to, some);
            std::move(some.begin(), some.end(), std::back_inserter(files));
        }
    }
    writeFiles(reading.sun);
    writeFiles(files);
    return 0;
}

int describeEnvironment(const SourceArguments& from, const InfoArguments& arguments) {
    const std::string& thumbnail = arguments.thumbnail;
    if (!thumbnail.empty()) {
        checkSavable(thumbnail);
        requireWritable(thumbnail);
    }
    const WorkSource source = loadWorkSource(from.in, from.layout.inLayout);
    const EnvironmentInfo info = infoOf(source);
    fmt::print("{}", arguments.json ? jsonOf(info) : textOf(info));
    if (!thumbnail.empty()) saveImage(thumbnail, contactSheet(source));
    return 0;
}

}  // namespace tukor
