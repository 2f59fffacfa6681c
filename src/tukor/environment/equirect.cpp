#include "tukor/environment/equirect.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "tukor/base/error.h"
#include "tukor/base/parallel.h"
#include "tukor/environment/equirect_area.h"
#include "tukor/environment/equirect_rows.h"
#include "tukor/environment/float4.h"

namespace tukor {

namespace {

constexpr float kPi = std::numbers::pi_v<float>;

/// The four pixels around a place and how far it lies between them; pixel units.
Float4 bilinear(const Image& panorama, float x, float y) noexcept {
    const int width = panorama.width(), height = panorama.height();
    const float u = x + 0.5f, v = y + 0.5f;  // so that truncation is floor
    const int column = static_cast<int>(u) - 1, row = static_cast<int>(v) - 1;
    const float right = u - static_cast<float>(column + 1);
    const float down = v - static_cast<float>(row + 1);
    const glm::vec3* above;
    const glm::vec3* below;
    Float4 a, b, c, d;
    if (column >= 0 && row >= 0 && column + 2 < width && row + 1 < height) {
        above = &panorama.at(column, row);
        below = above + width;
        a = loadFloat4(above);
        b = loadFloat4(above + 1);
        c = loadFloat4(below);
        d = loadFloat4(below + 1);
    } else {
        const auto pixel = [&](int i, int j) {
            // Over a pole lies the other side of the same row.
            const bool over = j < 0 || j >= height;
            const int wrapped = (i + width + (over ? width / 2 : 0)) % width;
            return float4(panorama.at(wrapped, j < 0 ? 0 : std::min(j, height - 1)));
        };
        a = pixel(column, row);
        b = pixel(column + 1, row);
        c = pixel(column, row + 1);
        d = pixel(column + 1, row + 1);
    }
    a += (b - a) * right;
    c += (d - c) * right;
    return a + (c - a) * down;
}

/// Taps, at half texels from the middle out, of the filter that takes samples at half texels to the
/// texels whose bilinear interpolation fits those samples best.
///
/// The normal equations of that fit are, along one axis, M c = (1/4, 1/2, 1/4) * samples with M =
/// (1/8, 3/4, 1/8). The inverse of M falls off as r^|k| with r = sqrt(8) - 3; two terms on each
/// side leave 0.7 %, which normalising spreads out.
std::array<float, 6> fittingTaps() {
    const double r = std::sqrt(8.0) - 3.0;
    const double sum = 1.0 + 2.0 * r + 2.0 * r * r;
    const std::array<double, 4> inverse = {1.0 / sum, r / sum, r * r / sum, 0.0};
    std::array<float, 6> taps{};
    for (std::size_t i = 0; i < taps.size(); ++i)
        taps[i] = static_cast<float>(i % 2 == 0 ? 0.5 * inverse[i / 2]
                                                : 0.25 * (inverse[i / 2] + inverse[i / 2 + 1]));
    return taps;
}

/// The texels whose bilinear interpolation fits that of the panorama best.
CubeMap fittedCube(const Image& panorama, int faceSize, const Progress& progress) {
    const std::array<float, 6> taps = fittingTaps();
    constexpr int kReach = 5;              // half texels to each side of a texel's centre
    constexpr int kRing = 2 * kReach + 1;  // lines of samples that one line of texels needs
    constexpr int kBand = 32;              // lines of texels a piece of work
    const int samples = 2 * faceSize + 2 * kReach - 1;
    const auto size = static_cast<std::size_t>(faceSize);
    const float half = 1.0f / static_cast<float>(faceSize);
    const int bands = (faceSize + kBand - 1) / kBand;

    CubeMap cube(faceSize);
    (void)parallelFor(0, 6 * bands, 1, progress, [&](int begin, int end) {
        EquirectRow places(panorama.width(), panorama.height(), samples);
        std::vector<Float4> line(static_cast<std::size_t>(samples));
        // Of each line of samples: filtered along s, and its range within half a texel.
        std::array<std::vector<Float4>, kRing> filtered, least, most;
        for (int i = 0; i < kRing; ++i)
            for (auto* ring : {&filtered, &least, &most})
                (*ring)[static_cast<std::size_t>(i)].resize(size);
        for (int band = begin; band < end; ++band) {
            const auto face = static_cast<CubeFace>(band / bands);
            const int firstRow = band % bands * kBand;
            const int lastRow = std::min(firstRow + kBand, faceSize) - 1;
            // Line j of samples lies at t = j / faceSize - 1: texel centres are the odd lines.
            for (int j = 2 * firstRow + 1 - kReach; j <= 2 * lastRow + 1 + kReach; ++j) {
                places.place(face, static_cast<float>(j) * half - 1.0f,
                             static_cast<float>(1 - kReach) * half - 1.0f, half);
                for (std::size_t i = 0; i < line.size(); ++i)
                    line[i] = bilinear(panorama, places.columns[i], places.rows[i]);
                const auto slot = static_cast<std::size_t>((j + kRing) % kRing);
                for (std::size_t i = 0; i < size; ++i) {
                    const Float4* centre = &line[2 * i + kReach];
                    Float4 sum = taps[0] * centre[0];
                    for (int k = 1; k <= kReach; ++k)
                        sum += taps[static_cast<std::size_t>(k)] * (centre[-k] + centre[k]);
                    filtered[slot][i] = sum;
                    least[slot][i] = min(centre[0], min(centre[-1], centre[1]));
                    most[slot][i] = max(centre[0], max(centre[-1], centre[1]));
                }
                const int row = (j - 1 - kReach) / 2;  // complete when j is its last line
                if ((j - 1 - kReach) % 2 != 0 || row < firstRow) continue;
                const auto lineAt = [&](int offset) {
                    return static_cast<std::size_t>((j - kReach + offset + kRing) % kRing);
                };
                glm::vec3* texel = &cube.texels(face)[static_cast<std::size_t>(row) * size];
                for (std::size_t i = 0; i < size; ++i) {
                    Float4 sum = taps[0] * filtered[lineAt(0)][i];
                    for (int k = 1; k <= kReach; ++k)
                        sum += taps[static_cast<std::size_t>(k)] *
                               (filtered[lineAt(-k)][i] + filtered[lineAt(k)][i]);
                    const Float4 low =
                        min(least[lineAt(0)][i], min(least[lineAt(-1)][i], least[lineAt(1)][i]));
                    const Float4 high =
                        max(most[lineAt(0)][i], max(most[lineAt(-1)][i], most[lineAt(1)][i]));
                    // Around a sun the fit would ring: dark by more than there is, bright spots
                    // beyond.
                    texel[i] = vec3FromFloat4(min(max(sum, 0.75f * low), 1.25f * high));
                }
            }
        }
    });
    return cube;
}

}  // namespace

glm::vec2 equirectFromDirection(glm::vec3 direction) noexcept {
    const float across = std::sqrt(direction.x * direction.x + direction.z * direction.z);
    return {std::atan2(direction.x, -direction.z) / (2.0f * kPi) + 0.5f,
            std::atan2(across, direction.y) / kPi};
}

glm::vec3 directionFromEquirect(glm::vec2 place) noexcept {
    const float longitude = 2.0f * kPi * (place.x - 0.5f);
    const float colatitude = kPi * place.y;
    const float across = std::sin(colatitude);
    return {across * std::sin(longitude), std::cos(colatitude), -across * std::cos(longitude)};
}

glm::vec3 equirectRadiance(const Image& panorama, glm::vec3 direction) noexcept {
    const glm::vec2 place = equirectFromDirection(direction);
    // In this order of arguments a NaN becomes 0: no direction reads out of bounds.
    const float x = std::min(std::max(0.0f, place.x), 1.0f) * static_cast<float>(panorama.width());
    const float y = std::min(std::max(0.0f, place.y), 1.0f) * static_cast<float>(panorama.height());
    return vec3FromFloat4(bilinear(panorama, x, y));
}

float equirectDensity(int width) noexcept {
    return static_cast<float>(width) / kPi;
}

int faceSizeForEquirect(int width) noexcept {
    int faceSize = 1;
    while (static_cast<float>(faceSize) < equirectDensity(width)) faceSize *= 2;
    return faceSize;
}

CubeMap cubeFromEquirect(const Image& panorama, int faceSize, const Progress& progress) {
    TUKOR_ASSERT(faceSize >= 1 && !panorama.empty());
    // Means of one value are that value, but not to the last bit.
    const std::span<const glm::vec3> pixels = panorama.pixels();
    if (std::all_of(pixels.begin(), pixels.end(),
                    [&](const glm::vec3& pixel) { return pixel == pixels.front(); })) {
        CubeMap cube(faceSize);
        for (const CubeFace face : kCubeFaces)
            std::fill(cube.texels(face).begin(), cube.texels(face).end(), pixels.front());
        return cube;
    }
    return static_cast<float>(faceSize) >= equirectDensity(panorama.width())
               ? fittedCube(panorama, faceSize, progress)
               : areaCubeFromEquirect(panorama, faceSize);
}

}  // namespace tukor
