// `tukor environment`: captured light converted, filtered and measured.
#include <memory>
#include <set>
#include <utility>

#include "command.h"
#include "environment_actions.h"
#include "environment_checks.h"

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

constexpr std::array<std::pair<Supercompression, std::string_view>, 2> kCompressionSpellings = {
    {{Supercompression::none, "none"}, {Supercompression::zstd, "zstd"}}};

constexpr std::array<std::pair<FilterKind, std::string_view>, 6> kKindSpellings = {
    {{FilterKind::ggx, "ggx"},
     {FilterKind::charlie, "charlie"},
     {FilterKind::irradiance, "irradiance"},
     {FilterKind::blur, "blur"},
     {FilterKind::sh, "sh"},
     {FilterKind::brdf, "brdf"}}};
constexpr std::array<std::pair<Quantity, std::string_view>, 2> kQuantitySpellings = {
    {{Quantity::radiance, "radiance"}, {Quantity::irradiance, "irradiance"}}};

}  // namespace

template <OptionsOf<LayoutArguments> Options, class Visitor>
void describe(Options& o, Visitor&& field) {
    field("in-layout", o.inLayout, Spellings<PictureForm>(kFormSpellings),
          "how IN is laid out; found by its shape, except octahedral and ball");
}

template <OptionsOf<SourceArguments> Options, class Visitor>
void describe(Options& o, Visitor&& field) {
    field(
        "from", o.from, Spellings<Orientation>(kOrientationSpellings),
        "the program that IN is oriented for. Its panoramas have in the middle, in glTF's axes: "
        "opengl and unreal -Z, blender and three +X, openexr and filament +Z. Its cube maps are as "
        "OpenGL's, but three's mirrored, unreal's with Z up, openexr's upright seen from inside");
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
          "or 256 for a filtered face, 32 of irradiance");
    field("to", o.to, Spellings<Orientation>(kOrientationSpellings),
          "the program that OUT is oriented for");
    field("format", o.format, Spellings<TexelFormat>(kTexelFormatSpellings),
          "of pixels: half, or any of these, in .dds, .ktx and .ktx2; float, or half, in .exr");
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

namespace {

struct AllArguments {
    SourceArguments source;
    TargetArguments target;
    FilterArguments filter;
    DevelopOptions develop{.tonemap = Tonemap::none};
    InfoArguments info;
    std::set<std::string> given;  // the options on the command line
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
    for (CommandOption& option : command.options) {
        if (option.names == "--exposure")  // that of `tukor render` is of pictures only
            option.help =
                "each stop doubles the radiance, in every type of file, chains, harmonics and the "
                "sun; 0 leaves it as it is";
        option.read = [&all, name = option.names,
                       read = std::move(option.read)](const std::vector<std::string>& texts) {
            all.given.insert(name);
            read(texts);
        };
    }
}

Command convertCommand() {
    auto all = std::make_shared<AllArguments>();
    Command command{
        .name = "convert",
        .help = "from one layout, size or file type to another",
        .footer =
            "Examples\n"
            "  tukor environment convert street.hdr -o street_{}.exr --size 512\n"
            "  tukor environment convert sky_{}.png -o sky.exr --to blender\n"
            "  tukor environment convert studio -o studio.hdr --size 2048\n"
            "  tukor environment convert probe.jpg --in-layout ball -o panorama.hdr\n"
            "  tukor environment convert noon.exr -o sunless.exr --sun sun.json",
        .check = [all] { checkGiven(all->given, all->target.out, std::nullopt); },
        .run = [all] { return convertEnvironment(all->source, all->target, all->develop); }};
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
        .check = [all] { checkGiven(all->given, all->target.out, all->filter.kind); },
        .run =
            [all] {
                return filterEnvironment(all->source, all->target, all->filter, all->develop);
            }};
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
                        "  tukor environment info sky_{}.png --json",
                    .run = [all] { return describeEnvironment(all->source, all->info); }};
    addSource(command, *all, Needs::something);
    command.options.push_back(textOption("--thumbnail", all->info.thumbnail, "OUT",
                                         "a contact sheet: three exposures and the six faces"));
    command.options.push_back(flagOption("--json", all->info.json, "figures as JSON"));
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
