#include "tukor/environment/environment_info.h"

#include <cmath>
#include <numbers>
#include <optional>

#include <fmt/format.h>

#include "tukor/environment/cube_mips.h"
#include "tukor/environment/equirect.h"
#include "tukor/environment/harmonics.h"
#include "tukor/environment/layout.h"
#include "tukor/environment/panorama.h"
#include "tukor/environment/sun.h"

namespace tukor {

std::string describeWork(WorkSource source) {
    std::string text = fmt::format("layout     {}\nsize       {} x {}\n", source.layout,
                                   source.width, source.height);
    const Image& panorama = panoramaOf(source);
    glm::vec3 least(INFINITY), most(0.0f);
    for (const glm::vec3& pixel : panorama.pixels()) {
        least = glm::min(least, pixel);
        most = glm::max(most, pixel);
    }
    const Spectrum spectrum = spectrumOf(panorama, 8);
    const auto triple = [](glm::dvec3 v) {
        return fmt::format("{:.5g} {:.5g} {:.5g}", v.x, v.y, v.z);
    };
    text += fmt::format("least      {}\nmost       {}\nmean       {}\n", triple(least),
                        triple(most), triple(spectrum.mean));
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
