#include "tukor/environment/environment_info.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tukor/base/number_text.h"
#include "tukor/environment/clipping.h"
#include "tukor/environment/cube_mips.h"
#include "tukor/environment/equirect.h"
#include "tukor/environment/layout.h"
#include "tukor/environment/panorama.h"

namespace tukor {

namespace {

/// Adds to the range of the texels that came out of the file, not of what is made of them.
void addTexels(EnvironmentInfo& info, std::span<const glm::vec3> texels) {
    const float largest = largestOf(TexelFormat::rgba16f);
    for (const glm::vec3& texel : texels) {
        info.least = glm::min(info.least, texel);
        info.most = glm::max(info.most, texel);
        info.aboveHalf += std::max({texel.x, texel.y, texel.z}) > largest ? 1 : 0;
    }
}

double degrees(float radians) {
    return static_cast<double>(radians) * 180.0 / std::numbers::pi;
}

std::string triple(glm::dvec3 v) {
    v += 0.0;  // -0 becomes 0
    return fmt::format("{:.5g} {:.5g} {:.5g}", v.x, v.y, v.z);
}

double rounded(double value) {  // 0.1, not what the float next to it is
    return numberFromText(fmt::format("{:.7g}", value)).value();
}

nlohmann::ordered_json list(glm::dvec3 v) {
    v += 0.0;
    return {rounded(v.x), rounded(v.y), rounded(v.z)};
}

}  // namespace

EnvironmentInfo infoOf(WorkSource source) {
    EnvironmentInfo info;
    info.layout = source.layout;
    info.width = source.width;
    info.height = source.height;
    info.repairs = source.warnings;
    if (source.square || !source.cube)
        addTexels(info, (source.square ? source.square : source.panorama)->pixels());
    else
        for (const CubeFace face : kCubeFaces) addTexels(info, source.cube->texels(face));
    const Image& panorama = panoramaOf(source);
    const Spectrum spectrum = spectrumOf(panorama, 8);
    info.mean = spectrum.mean;
    info.faceSize = source.cube ? source.cube->faceSize() : faceSizeForEquirect(panorama.width());
    info.sun = findSun(panorama);
    info.harmonics = harmonicsOf(spectrum, 3);
    return info;
}

std::string textOf(const EnvironmentInfo& info) {
    std::string text =
        fmt::format("layout     {}\nsize       {} x {}\n", info.layout, info.width, info.height);
    text += fmt::format("least      {}\nmost       {}\nmean       {}\n", triple(info.least),
                        triple(info.most), triple(info.mean));
    if (info.aboveHalf > 0)
        text += fmt::format("above half {} pixel{}, brighter than 65504\n", info.aboveHalf,
                            info.aboveHalf == 1 ? "" : "s");
    text += fmt::format("cube map   {} texels an edge\n", info.faceSize);
    if (info.repairs.empty()) text += "repaired   nothing\n";
    for (const std::string& repair : info.repairs) text += fmt::format("repaired   {}\n", repair);
    if (const std::optional<Sun>& sun = info.sun)
        text += fmt::format(
            "sun        towards {}, radius {:.3g} degrees, {:.3g} times the sky around it\n"
            "           irradiance {}\n",
            triple(sun->direction), degrees(sun->angularRadius),
            static_cast<double>(sun->brightness), triple(sun->irradiance));
    else
        text += "sun        none\n";
    for (int l = 0; l < info.harmonics.bands; ++l)
        for (int m = -l; m <= l; ++m)
            text += fmt::format(
                "SH {},{:<2}    {}\n", l, m,
                triple(info.harmonics.coefficients[static_cast<std::size_t>(l * (l + 1) + m)]));
    return text;
}

std::string jsonOf(const EnvironmentInfo& info) {
    nlohmann::ordered_json json{
        {"layout", info.layout},
        {"width", info.width},
        {"height", info.height},
        {"least", list(info.least)},
        {"most", list(info.most)},
        {"mean", list(info.mean)},
        {"aboveHalf", info.aboveHalf},
        {"faceSize", info.faceSize},
        {"repairs", info.repairs},
        {"sun", nullptr},
        {"sphericalHarmonics", nlohmann::ordered_json::array()},
    };
    if (const std::optional<Sun>& sun = info.sun)
        json["sun"] = {{"direction", list(sun->direction)},
                       {"angularRadiusDegrees", rounded(degrees(sun->angularRadius))},
                       {"irradiance", list(sun->irradiance)},
                       {"timesSky", rounded(static_cast<double>(sun->brightness))}};
    for (const glm::dvec3& coefficient : info.harmonics.coefficients)
        json["sphericalHarmonics"].push_back(list(coefficient));
    // Names of files may be in it, in whatever encoding.
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

Image contactSheet(WorkSource source) {
    constexpr int kWidth = 768, kFace = kWidth / 6;
    const CubeMap faces =
        source.cube ? resizedCube(*source.cube, kFace) : cubeFromEquirect(*source.panorama, kFace);
    const Image panorama = resizedPanorama(panoramaOf(source), kWidth);
    double mean = 0.0;
    for (const glm::vec3& pixel : panorama.pixels())
        mean += static_cast<double>(pixel.x + pixel.y + pixel.z) / 3.0;
    mean /= static_cast<double>(panorama.pixels().size());
    // The middle exposure brings the mean to 0.18, a photographer's middle grey.
    const auto exposure = static_cast<float>(mean > 0.0 ? 0.18 / mean : 1.0);
    Image sheet(kWidth, 3 * kWidth / 2 + kFace);
    for (int strip = 0; strip < 3; ++strip)
        for (int row = 0; row < kWidth / 2; ++row)
            for (int column = 0; column < kWidth; ++column)
                sheet.at(column, strip * kWidth / 2 + row) =
                    exposure * std::exp2(2.0f * static_cast<float>(strip - 1)) *
                    panorama.at(column, row);
    const Image below = pictureFromCube(faces, Layout::hstrip);
    for (int row = 0; row < kFace; ++row)
        for (int column = 0; column < kWidth; ++column)
            sheet.at(column, 3 * kWidth / 2 + row) = exposure * below.at(column, row);
    return sheet;
}

}  // namespace tukor
