// `tukor environment`: captured light converted, filtered and measured.
#include <cmath>
#include <filesystem>
#include <memory>
#include <numbers>
#include <optional>

#include <fmt/format.h>

#include "command.h"
#include "interrupt.h"
#include "messages.h"
#include "progress_bar.h"
#include "tukor/app/options.h"
#include "tukor/base/file.h"
#include "tukor/environment/environment_work.h"
#include "tukor/environment/texture_chain.h"

namespace tukor {
namespace {

constexpr std::array<std::pair<PictureForm, std::string_view>, 8> kFormSpellings = {
    {{PictureForm::equirect, "equirect"},
     {PictureForm::faces, "faces"},
     {PictureForm::hcross, "hcross"},
     {PictureForm::vcross, "vcross"},
     {PictureForm::hstrip, "hstrip"},
     {PictureForm::vstrip, "vstrip"},
     {PictureForm::octahedral, "octahedral"},
     {PictureForm::ball, "ball"}}};

/// How what is read is laid out.
struct LayoutArguments {
    std::optional<PictureForm> inLayout;
};

/// What is read, and how it is turned.
struct SourceArguments {
    std::string in;
    LayoutArguments layout;
    Orientation from = Orientation::opengl;
    float rotateDegrees = 0.0f;
    std::string sun;
};

/// What is written.
struct TargetArguments {
    std::string out;
    std::optional<PictureForm> layout;
    std::optional<int> size;
    Orientation to = Orientation::opengl;
    TexelFormat texels = TexelFormat::rgba16f;
    Supercompression compression = Supercompression::none;
};

constexpr std::array<std::pair<Supercompression, std::string_view>, 2> kCompressionSpellings = {
    {{Supercompression::none, "none"}, {Supercompression::zstd, "zstd"}}};

enum class FilterKind { ggx, charlie, irradiance, blur, sh, brdf };
constexpr std::array<std::pair<FilterKind, std::string_view>, 6> kKindSpellings = {
    {{FilterKind::ggx, "ggx"},
     {FilterKind::charlie, "charlie"},
     {FilterKind::irradiance, "irradiance"},
     {FilterKind::blur, "blur"},
     {FilterKind::sh, "sh"},
     {FilterKind::brdf, "brdf"}}};
enum class Quantity { radiance, irradiance };
constexpr std::array<std::pair<Quantity, std::string_view>, 2> kQuantitySpellings = {
    {{Quantity::radiance, "radiance"}, {Quantity::irradiance, "irradiance"}}};

struct FilterArguments {
    FilterKind kind = FilterKind::ggx;
    int levels = 5;
    RoughnessScale scale = RoughnessScale::filament;
    float blurDegrees = 5.0f;
    int bands = 3;
    HarmonicWindow window = HarmonicWindow::none;
    Quantity quantity = Quantity::radiance;
};

template <OptionsOf<LayoutArguments> Options, class Visitor>
void describe(Options& o, Visitor&& field) {
    field("in-layout", o.inLayout, Spellings<PictureForm>(kFormSpellings),
          "how IN is laid out; found by its shape, except octahedral and ball");
}

template <OptionsOf<SourceArguments> Options, class Visitor>
void describe(Options& o, Visitor&& field) {
    field("from", o.from, Spellings<Orientation>(kOrientationSpellings),
          "the program that IN is oriented for: what it sees in the middle of a panorama");
    field("rotate", o.rotateDegrees, Measure<float>{"DEG", {-360.0f, 360.0f}},
          "turn about +Y, counter-clockwise seen from above");
    field("sun", o.sun, Placeholder{"FILE"},
          "find the sun, write its direction, size and irradiance to a JSON file, and go on "
          "without it");
}

template <OptionsOf<TargetArguments> Options, class Visitor>
void describe(Options& o, Visitor&& field) {
    field("layout", o.layout, Spellings<PictureForm>(kFormSpellings),
          "how OUT is laid out; faces when OUT contains {}, else equirect (convert) or hcross "
          "(filter)");
    field("size", o.size, Measure<int>{"N", {1, 16384}},
          "width of a panorama, edge of a face or of an octahedral or ball picture; as detailed as "
          "IN, "
          "or 256 for a filtered face");
    field("to", o.to, Spellings<Orientation>(kOrientationSpellings),
          "the program that OUT is oriented for");
    field("texels", o.texels, Spellings<TexelFormat>(kTexelFormatSpellings),
          "of .dds, .ktx and .ktx2");
    field("compression", o.compression, Spellings<Supercompression>(kCompressionSpellings),
          "of .ktx2");
}

template <OptionsOf<FilterArguments> Options, class Visitor>
void describe(Options& o, Visitor&& field) {
    field("kind", o.kind, Spellings<FilterKind>(kKindSpellings),
          "ggx or charlie: a chain from sharp to rough, OUT_0 to OUT_N; irradiance: over pi, one "
          "map; blur: "
          "one map; sh: spherical harmonics, .json or .h; brdf: the split-sum table, without IN");
    field("levels", o.levels, Measure<int>{"N", {1, 14}},
          "of a chain; each half the size of the one before");
    field("roughness", o.scale, Spellings<RoughnessScale>(kRoughnessScaleSpellings),
          "of the levels: filament, alpha = (1 - sqrt(1 - x))^2, or linear, alpha = x^2");
    field("blur", o.blurDegrees, Measure<float>{"DEG", {0.2f, 90.0f}},
          "standard deviation of --kind blur");
    field("bands", o.bands, Measure<int>{"N", {1, kMaxBands}}, "of --kind sh: N^2 coefficients");
    field("window", o.window, Spellings<HarmonicWindow>(kHarmonicWindowSpellings),
          "fades the bands of --kind sh against ringing");
    field("quantity", o.quantity, Spellings<Quantity>(kQuantitySpellings), "of --kind sh");
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
    WorkSource source = loadWorkSource(arguments.in, arguments.layout.inLayout);
    for (const std::string& warning : source.warnings)
        warn(fmt::format("{}: {}", arguments.in, warning));
    turn(source, turnFrom(arguments.from) +
                     static_cast<double>(arguments.rotateDegrees) * std::numbers::pi / 180.0);
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

int convert(const SourceArguments& from, const TargetArguments& to, const DevelopOptions& develop) {
    const PictureForm form = formOf(to, PictureForm::equirect);
    checkWorkTarget(to.out, form);
    requireWritable(to.out);
    WorkSource source = readSource(from);
    turn(source, -turnFrom(to.to));
    saveWork(to.out, source, form, to.size, saveOptions(develop), {to.texels, to.compression});
    return 0;
}

int filter(const SourceArguments& from, const TargetArguments& to, const FilterArguments& arguments,
           const DevelopOptions& develop) {
    const SaveOptions save = saveOptions(develop);
    if (arguments.kind == FilterKind::brdf) {
        checkSavable(to.out);
        saveImage(to.out, brdfTable(to.size.value_or(128)), save);
        return 0;
    }
    if (from.in.empty()) throw Error("IN is missing: the environment to filter");
    requireWritable(to.out);
    const std::string extension = lowerExtension(to.out);
    if (arguments.kind == FilterKind::sh) {
        if (extension != ".json" && extension != ".h")
            throw Error(fmt::format("{}: spherical harmonics are written to .json or .h", to.out));
        const Spectrum spectrum =
            spectrumOf(panoramaOf(readSource(from)), std::max(arguments.bands - 1, 8));
        Harmonics harmonics = windowed(harmonicsOf(spectrum, arguments.bands), arguments.window);
        const bool irradiance = arguments.quantity == Quantity::irradiance;
        if (irradiance) harmonics = irradianceOf(std::move(harmonics));
        const char* quantity = irradiance ? "irradiance" : "radiance";
        writeFile(to.out, extension == ".json"
                              ? jsonOf(harmonics, quantity)
                              : cHeaderOf(harmonics, quantity, "environmentHarmonics"));
        return 0;
    }

    const PictureForm form = formOf(to, PictureForm::hcross);
    checkWorkTarget(to.out, form);
    WorkSource source = readSource(from);
    turn(source, -turnFrom(to.to));
    const Image& panorama = panoramaOf(source);
    const int size = to.size.value_or(256);
    const TextureOptions texture{to.texels, to.compression};
    const auto write = [&](const std::string& path, CubeMap cube) {
        WorkSource result;
        result.cube = std::move(cube);
        saveWork(path, result, form, std::nullopt, save, texture);
    };
    if (arguments.kind == FilterKind::ggx || arguments.kind == FilterKind::charlie) {
        if (size >> (arguments.levels - 1) < 1)
            throw Error(fmt::format("{} levels from faces of {} texels; expected at most {}",
                                    arguments.levels, size, static_cast<int>(std::log2(size)) + 1));
        const InterruptWatch watch;
        ProgressBar bar(ProgressBar::Loudness::terminal);
        PrefilteredChain chain = prefilteredChain(
            panorama,
            {.faceSize = size,
             .levels = arguments.levels,
             .shape = arguments.kind == FilterKind::ggx ? LobeShape::ggx : LobeShape::charlie,
             .scale = arguments.scale},
            [&](float fraction) {
                bar.show(fraction);
                return !InterruptWatch::interrupted();
            });
        if (chain.levels.empty()) {
            fmt::print(stderr, "tukor: stopped; nothing was written\n");
            return kExitInterrupted;
        }
        if (hasTextureExtension(to.out)) {
            saveLevels(to.out, chain.levels, texture);
            return 0;
        }
        for (std::size_t level = 0; level < chain.levels.size(); ++level)
            write(levelPath(to.out, level), std::move(chain.levels[level]));
        return 0;
    }
    const bool blur = arguments.kind == FilterKind::blur;
    write(to.out,
          blurredCube(panorama,
                      blur ? Lobe{LobeShape::gaussian, static_cast<double>(arguments.blurDegrees) *
                                                           std::numbers::pi / 180.0}
                           : Lobe{LobeShape::lambert, 1.0},
                      blur ? size : to.size.value_or(32)));
    return 0;
}

int info(const SourceArguments& from, const std::string& thumbnail) {
    if (!thumbnail.empty()) {
        checkSavable(thumbnail);
        requireWritable(thumbnail);
    }
    const WorkSource source = loadWorkSource(from.in, from.layout.inLayout);
    fmt::print("{}", describeWork(source));
    if (!thumbnail.empty()) saveImage(thumbnail, contactSheet(source));
    return 0;
}

struct AllArguments {
    SourceArguments source;
    TargetArguments target;
    FilterArguments filter;
    DevelopOptions develop{.tonemap = Tonemap::none};
    std::string thumbnail;
};

enum class Needs { something, nothing };  // of IN

void addSource(Command& command, AllArguments& all, Needs needs) {
    CommandOption in =
        textOption("IN", all.source.in, "",
                   "an image file, a pattern of six (sky_{}.png), a folder, or studio, sky");
    in.required = needs == Needs::something;
    command.options.push_back(in);
    addOptions(command.options, "Source", all.source.layout);
}

/// What reads an environment and writes one.
void addSourceAndTarget(Command& command, AllArguments& all, Needs needs) {
    addSource(command, all, needs);
    addOptions(command.options, "Source", all.source);
    command.options.push_back(required(
        textOption("-o,--output", all.target.out, "OUT",
                   std::string(".exr .hdr .png .jpg, with {} for six files; .dds .ktx .ktx2 for a "
                               "cube map and its levels") +
                       (needs == Needs::something ? "" : "; .json .h for --kind sh"))));
    addOptions(command.options, "Target", all.target);
    addOptions(command.options, "Development", all.develop);
}

Command convertCommand() {
    auto all = std::make_shared<AllArguments>();
    Command command{.name = "convert",
                    .help = "from one layout, size or file type to another",
                    .footer =
                        "Examples\n"
                        "  tukor environment convert street.hdr -o street_{}.exr --size 512\n"
                        "  tukor environment convert sky_{}.png -o sky.exr --to blender\n"
                        "  tukor environment convert studio -o studio.hdr --size 2048\n"
                        "  tukor environment convert probe.jpg --in-layout ball -o panorama.hdr\n"
                        "  tukor environment convert noon.exr -o sunless.exr --sun sun.json",
                    .run = [all] { return convert(all->source, all->target, all->develop); }};
    addSourceAndTarget(command, *all, Needs::something);
    return command;
}

Command filterCommand() {
    auto all = std::make_shared<AllArguments>();
    Command command{
        .name = "filter",
        .help = "for rough surfaces, diffuse light and backgrounds",
        .footer =
            "Examples\n"
            "  tukor environment filter street.hdr -o chain.ktx2 --size 256 --levels 5\n"
            "  tukor environment filter street.hdr -o level_{}.exr --kind charlie\n"
            "  tukor environment filter street.hdr -o light.h --kind sh --quantity irradiance\n"
            "  tukor environment filter -o brdf.exr --kind brdf --size 128",
        .run = [all] { return filter(all->source, all->target, all->filter, all->develop); }};
    addOptions(command.options, "Filter", all->filter);
    addSourceAndTarget(command, *all, Needs::nothing);  // --kind brdf
    return command;
}

Command infoCommand() {
    auto all = std::make_shared<AllArguments>();
    Command command{.name = "info",
                    .help = "size, layout, range, sun and harmonics",
                    .footer =
                        "Examples\n"
                        "  tukor environment info street.hdr --thumbnail sheet.png\n"
                        "  tukor environment info sky_{}.png",
                    .run = [all] { return info(all->source, all->thumbnail); }};
    addSource(command, *all, Needs::something);
    command.options.push_back(textOption("--thumbnail", all->thumbnail, "OUT",
                                         "a contact sheet: three exposures and the six faces"));
    return command;
}

}  // namespace

Command environmentCommand() {
    return {.name = "environment",
            .help = "captured light: convert, filter, measure",
            .footer =
                "Examples\n"
                "  tukor environment info street.hdr --thumbnail sheet.png\n"
                "  tukor environment convert street.hdr -o street.ktx2 --size 512\n"
                "  tukor environment filter street.hdr -o chain.ktx2\n"
                "COMMAND --help tells the options of each",
            .commands = {convertCommand(), filterCommand(), infoCommand()}};
}

}  // namespace tukor
