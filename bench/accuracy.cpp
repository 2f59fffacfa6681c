// How near the renderers come to pictures known in closed form, over all photographic environments.
//
//     accuracy [--size WxH] [--oracle N] [--face-size N] [--only TEXT] [PANORAMA...]
//
// 640x360, the closed form supersampled 16 x 16 times, and blender-data's eight panoramas unless
// told otherwise; --only keeps the runs whose description contains TEXT. Prints a table of RMSE in
// codes of 8-bit sRGB of the clipped linear picture; the exit status is 1 when one is above its
// limit.
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "acceptance/subjects.h"
#include "oracle/equirect.h"
#include "tukor/base/error.h"
#include "tukor/image/compare.h"
#include "tukor/image/image_file.h"

namespace {

using namespace tukor;
using namespace tukor::acceptance;

struct Options {
    int width = 640;
    int height = 360;
    int oracleSamples = 16;
    EnvironmentOptions environment;
    std::string only;
    std::vector<std::string> panoramas;
};

Options parse(int argc, char** argv) {
    Options options;
    for (int i = 1; i < argc; ++i) {
        const std::string argument = argv[i];
        const bool more = i + 1 < argc;
        if (argument == "--size" && more) {
            if (std::sscanf(argv[++i], "%dx%d", &options.width, &options.height) != 2 ||
                options.width < 1 || options.height < 1) {
                throw Error(fmt::format("--size {}: expected WxH", argv[i]));
            }
        } else if (argument == "--oracle" && more) {
            options.oracleSamples = std::max(1, std::atoi(argv[++i]));
        } else if (argument == "--face-size" && more) {
            options.environment.faceSize = std::atoi(argv[++i]);
        } else if (argument == "--only" && more) {
            options.only = argv[++i];
        } else if (argument.starts_with("--")) {
            throw Error(fmt::format("{}: unknown option", argument));
        } else {
            options.panoramas.push_back(argument);
        }
    }
    if (options.panoramas.empty()) options.panoramas = installedPanoramas();
    if (options.panoramas.empty()) throw Error("no panoramas: install blender-data or name some");
    return options;
}

}  // namespace

int main(int argc, char** argv) try {
    const Options options = parse(argc, argv);
    int above = 0;
    for (const std::string& path : options.panoramas) {
        const Environment environment = loadEnvironment(path, options.environment);
        const oracle::Environment light = oracle::equirect(loadImage(path));
        const std::string name = std::filesystem::path(path).stem().string();
        std::map<std::string, Image> truths;
        for (const Trial& trial : trials()) {
            const std::string subject = describe(trial.subject);
            const std::string line =
                fmt::format("{:<10} {:<26} {:<24}", name, subject, describe(trial));
            if (line.find(options.only) == std::string::npos) continue;
            if (!truths.contains(subject)) {
                truths[subject] = expected(trial.subject, light, Camera{}, options.width,
                                           options.height, options.oracleSamples);
            }
            const Rendering rendering =
                rendered(trial, environment, Camera{}, options.width, options.height);
            const Comparison comparison = compareImages(rendering.radiance, truths[subject]);
            const bool bad = comparison.rmse8 > trial.limit || comparison.nonFinite > 0 ||
                             rendering.leaks > 0 || rendering.inconsistencies > 0;
            above += bad ? 1 : 0;
            fmt::print("{} {:7.3f} of {:4.1f}  leaks {} inconsistencies {}{}\n", line,
                       comparison.rmse8, trial.limit, rendering.leaks, rendering.inconsistencies,
                       bad ? "  <- above" : "");
            std::fflush(stdout);
        }
    }
    return above > 0 ? 1 : 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "accuracy: %s\n", error.what());
    return 2;
}
