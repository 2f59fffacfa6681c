#include "environment_checks.h"

#include <string_view>

#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/base/file.h"

namespace tukor {

void checkGiven(const std::set<std::string>& given, const std::string& out,
                std::optional<FilterKind> kind) {
    const std::string type = lowerExtension(out);
    const bool isPicture = type == ".png" || type == ".jpg" || type == ".jpeg";
    const bool isChain = kind == FilterKind::ggx || kind == FilterKind::charlie;
    const bool isHarmonics = kind == FilterKind::sh, isTable = kind == FilterKind::brdf;
    constexpr std::string_view kMaps = "pictures and cube maps, not of --kind sh and brdf";
    constexpr std::string_view kRead = "what reads an environment, not of --kind brdf";
    const struct {
        std::string_view option;
        bool applies;
        std::string_view owner;
    } rules[] = {
        {"--compression", type == ".ktx2", ".ktx2"},
        {"--exr-pixels", type == ".exr", ".exr"},
        {"--png-depth", type == ".png", ".png"},
        {"--jpeg-quality", isPicture && type != ".png", ".jpg"},
        {"--tonemap", isPicture, ".png and .jpg; others keep radiance as it is"},
        {"--levels", isChain, "--kind ggx and charlie"},
        {"--roughness", isChain, "--kind ggx and charlie"},
        {"--blur", kind == FilterKind::blur, "--kind blur"},
        {"--bands", isHarmonics, "--kind sh"},
        {"--window", isHarmonics, "--kind sh"},
        {"--quantity", isHarmonics, "--kind sh"},
        {"--layout", !isHarmonics && !isTable, kMaps},
        {"--to", !isHarmonics && !isTable, kMaps},
        {"--size", !isHarmonics, "pictures, cube maps and tables, not of --kind sh"},
        {"--format", !isHarmonics, "pictures, cube maps and tables, not of --kind sh"},
        {"IN", !isTable, kRead},
        {"--in-layout", !isTable, kRead},
        {"--from", !isTable, kRead},
        {"--rotate", !isTable, kRead},
        {"--sun", !isTable, kRead},
        {"--exposure", !isTable, kRead},
    };
    for (const auto& rule : rules)
        if (!rule.applies && given.contains(std::string(rule.option)))
            throw Error(fmt::format("{}: {} is of {}", out, rule.option, rule.owner));
}

}  // namespace tukor
