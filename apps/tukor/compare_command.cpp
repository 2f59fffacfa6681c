// `tukor compare`: how far two pictures are apart.
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "command.h"
#include "messages.h"
#include "tukor/image/compare.h"
#include "tukor/image/image_file.h"

namespace tukor {
namespace {

struct CompareArguments {
    std::string a;
    std::string b;
    std::string heatMap;
    std::optional<float> maxRmse;
};

template <OptionsOf<CompareArguments> Options, class Visitor>
void describe(Options& o, Visitor&& field) {
    field("heat-map", o.heatMap, Placeholder{"OUT"},
          "a picture of the differences: black none, through red to white for 32 codes and more");
    field("max-rmse", o.maxRmse, Measure<float>{"X", {0.0f, 255.0f}},
          "exit with status 1 when the root mean square of the differences is larger, in 8-bit "
          "codes");
}

int compare(const CompareArguments& arguments) {
    if (!arguments.heatMap.empty()) checkSavable(arguments.heatMap);
    const Image a = loadImage(arguments.a);
    const Image b = loadImage(arguments.b);
    const Comparison comparison = compareImages(a, b);
    fmt::print("{}", report(comparison));
    if (!arguments.heatMap.empty()) saveImage(arguments.heatMap, heatMap(a, b));
    return arguments.maxRmse && !(comparison.rmse8 <= double(*arguments.maxRmse)) ? kExitFailure
                                                                                  : 0;
}

}  // namespace

Command compareCommand() {
    auto arguments = std::make_shared<CompareArguments>();
    Command command{
        .name = "compare",
        .help = "how far two pictures are apart",
        .footer =
            "Figures are in 8-bit sRGB codes of the pictures clipped to [0, 1], and relative to "
            "B.\n"
            "\n"
            "Examples\n"
            "  tukor compare new.exr reference.exr --heat-map difference.png\n"
            "  tukor compare new.png reference.png --max-rmse 0.5 || echo worse",
        .options = {required(textOption("A", arguments->a, "", "a picture: .exr .hdr .png .jpg")),
                    required(textOption("B", arguments->b, "", "the reference, of the same size"))},
        .run = [arguments] { return compare(*arguments); }};
    addOptions(command.options, "Comparison", *arguments);
    return command;
}

}  // namespace tukor
