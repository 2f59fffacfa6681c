#include "tukor/environment/environment_info.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>

#include <fmt/format.h>

#include "tukor/environment/clipping.h"
#include "tukor/environment/cube_mips.h"
#include "tukor/environment/equirect.h"
#include "tukor/environment/harmonics.h"
#include "tukor/environment/layout.h"
#include "tukor/environment/panorama.h"
#include "tukor/environment/sun.h"

namespace tukor {

namespace {

/// Of the texels that came out of the file, not of what is made of them.
struct TexelRange {
    glm::vec3 least = glm::vec3(INFINITY);
    glm::vec3 most = glm::vec3(0.0f);
    std::size_t aboveHalf = 0;  // texels with a component that half cannot hold

    void add(std::span<const glm::vec3> texels) {
        const float largest = largestOf(TexelFormat::rgba16f);
        for (const glm::vec3& texel : texels) {
            least = glm::min(least, texel);
            most = glm::max(most, texel);
            aboveHalf += std::max({texel.x, texel.y, texel.z}) > largest ? 1 : 0;
        }
    }
};

TexelRange rangeOf(const WorkSource& source) {
    TexelRange range;
    if (source.square || !source.cube) {
        range.add((source.square ? source.square : source.panorama)->pixels());
        return range;
    }
    for (const CubeFace face : kCubeFaces) range.add(source.cube->texels(face));
    return range;
}

}  // namespace

std::string describeWork(WorkSource source) {
    std::string text = fmt::format("layout     {}\nsize       {} x {}\n", source.layout,
                                   source.width, source.height);
    const TexelRange range = rangeOf(source);
    const Image& panorama = panoramaOf(source);
    const Spectrum spectrum = spectrumOf(panorama, 8);
    const auto triple = [](glm::dvec3 v) {
        v += 0.0;  // -0 becomes 0
        return fmt::format("{:.5g} {:.5g} {:.5g}", v.x, v.y, v.z);
    };
    text += fmt::format("least      {}\nmost       {}\nmean       {}\n", triple(range.least),
                        triple(range.most), triple(spectrum.mean));
    if (range.aboveHalf > 0)
        text += fmt::format("above half {} pixel{}, brighter than 65504\n", range.aboveHalf,
                            range.aboveHalf == 1 ? "" : "s");
    const int faceSize =
        source.cube ? source.cube->faceSize() : faceSizeForEquirect(panorama.width());
    text += fmt::format("cube map   {} texels an edge\n", faceSize);
    if (source.warnings.empty()) text += "repaired   nothing\n";
    for (const std::string& warning : source.warnings)
        text += fmt::format("repaired   {}\n", warning);
    if (const std::optional<Sun> sun = findSun(panorama)) {
        constexpr double kDegrees = 180.0 / std::numbers::pi;
        text += fmt::format(
            "sun        towards {}, radius {:.3g} degrees, {:.3g} times the sky around it\n"
            "           irradiance {}\n",
            triple(sun->direction), static_cast<double>(sun->angularRadius) * kDegrees,
            static_cast<double>(sun->brightness), triple(sun->irradiance));
    } else {
        text += "sun        none\n";
    }
    const Harmonics harmonics = harmonicsOf(spectrum, 3);
    for (int l = 0; l < 3; ++l)
        for (int m = -l; m <= l; ++m)
            text += fmt::format(
                "SH {},{:<2}    {}\n", l, m,
                triple(harmonics.coefficients[static_cast<std::size_t>(l * (l + 1) + m)]));
    return text;
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
