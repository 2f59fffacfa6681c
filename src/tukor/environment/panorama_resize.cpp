// Panoramas of another size, from panoramas and from cube maps.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "tukor/base/parallel.h"
#include "tukor/environment/cube_mips.h"
#include "tukor/environment/equirect.h"
#include "tukor/environment/float4.h"
#include "tukor/environment/panorama.h"
#include "tukor/environment/richardson.h"
#include "tukor/environment/unblurred.h"

namespace tukor {

namespace {

constexpr double kPi = std::numbers::pi;

/// A target pixel along one axis is the mean of three bilinear look-ups, which no more than three
/// source pixels in a row take part in: those before and after the one in the middle, by weight.
struct Taps {
    int middle;
    float before, after;
};

std::vector<Taps> growingTaps(int sourceSize, int targetSize) {
    std::vector<Taps> taps;
    for (int i = 0; i < targetSize; ++i) {
        std::array<double, 4> weights{};  // from the first look-up's left pixel on
        int first = 0;
        for (int k = 0; k < 3; ++k) {
            const double place = (i + (k + 0.5) / 3.0) * sourceSize / targetSize - 0.5;
            const double left = std::floor(place);
            if (k == 0) first = static_cast<int>(left);
            const auto at = static_cast<std::size_t>(static_cast<int>(left) - first);
            weights[at] += (1.0 - (place - left)) / 3.0;
            weights[at + 1] += (place - left) / 3.0;
        }
        taps.push_back({first + 1, static_cast<float>(weights[0]), static_cast<float>(weights[2])});
    }
    return taps;
}

/// In this form three pixels of one value give exactly that value.
Float4 blend(const Taps& taps, Float4 before, Float4 middle, Float4 after) {
    return middle + (taps.before * (before - middle) + taps.after * (after - middle));
}

/// A source row, grown across. Rows above the first and below the last are those of the far side.
void growRow(const Image& panorama, int row, const std::vector<Taps>& taps,
             std::vector<Float4>& line) {
    const int width = panorama.width(), height = panorama.height();
    const bool over = row < 0 || row >= height;
    const int inside = std::clamp(row, 0, height - 1);
    const auto pixel = [&](int column) {
        return float4(panorama.at((column + width + (over ? width / 2 : 0)) % width, inside));
    };
    const int half = over ? width / 2 : 0;
    const glm::vec3* const pixels = &panorama.at(0, inside);
    for (std::size_t i = 0; i < line.size(); ++i) {
        const int at = taps[i].middle + half;
        // The third load reads one float beyond its pixel.
        if (at >= 1 && at + 2 < width)
            line[i] = blend(taps[i], loadFloat4(pixels + at - 1), loadFloat4(pixels + at),
                            loadFloat4(pixels + at + 1));
        else
            line[i] = blend(taps[i], pixel(taps[i].middle - 1), pixel(taps[i].middle),
                            pixel(taps[i].middle + 1));
    }
}

Image grownPanorama(const Image& panorama, int width, const Progress& progress) {
    const int height = std::max(1, width / 2);
    const std::vector<Taps> across = growingTaps(panorama.width(), width);
    const std::vector<Taps> down = growingTaps(panorama.height(), height);
    Image image(width, height);
    (void)parallelFor(0, height, 64, progress, [&](int begin, int end) {
        std::array<std::vector<Float4>, 3> lines;  // source row j is in line j mod 3
        for (auto& line : lines) line.resize(static_cast<std::size_t>(width));
        const auto lineOf = [&](int row) -> std::vector<Float4>& {
            return lines[static_cast<std::size_t>((row + 3) % 3)];
        };
        int ready = down[static_cast<std::size_t>(begin)].middle - 2;
        for (int row = begin; row < end; ++row) {
            const Taps& taps = down[static_cast<std::size_t>(row)];
            for (ready = std::max(ready, taps.middle - 2); ready < taps.middle + 1;) {
                ++ready;
                growRow(panorama, ready, across, lineOf(ready));
            }
            const Float4* const before = lineOf(taps.middle - 1).data();
            const Float4* const middle = lineOf(taps.middle).data();
            const Float4* const after = lineOf(taps.middle + 1).data();
            glm::vec3* const pixels = &image.at(0, row);
            for (std::size_t i = 0; i < static_cast<std::size_t>(width); ++i)
                pixels[i] = vec3FromFloat4(blend(taps, before[i], middle[i], after[i]));
        }
    });
    return image;
}

Image shrunkPanorama(const Image& panorama, int width, const Progress& progress) {
    const int height = std::max(1, width / 2);
    std::vector<double> depths;  // of the edges of rows: 1 - cos(colatitude)
    for (int row = 0; row <= panorama.height(); ++row) {
        const double sine = std::sin(0.5 * kPi * row / panorama.height());
        depths.push_back(2.0 * sine * sine);
    }
    Image image(width, height);
    (void)parallelFor(0, height, 4, progress, [&](int begin, int end) {
        std::vector<glm::dvec3> line(static_cast<std::size_t>(panorama.width()));
        for (int row = begin; row < end; ++row) {
            const double top = static_cast<double>(row) * panorama.height() / height;
            const double bottom = static_cast<double>(row + 1) * panorama.height() / height;
            const auto depthAt = [&](double edge) {
                const double sine = std::sin(0.5 * kPi * edge / panorama.height());
                return 2.0 * sine * sine;
            };
            std::fill(line.begin(), line.end(), glm::dvec3(0.0));
            double bands = 0.0;
            for (int j = static_cast<int>(top); j < bottom && j < panorama.height(); ++j) {
                const auto at = static_cast<std::size_t>(j);
                const double band = (j + 1 <= bottom ? depths[at + 1] : depthAt(bottom)) -
                                    (j >= top ? depths[at] : depthAt(top));
                bands += band;
                const glm::vec3* const pixels = &panorama.at(0, j);
                for (std::size_t i = 0; i < line.size(); ++i)
                    line[i] += band * glm::dvec3(pixels[i]);
            }
            for (int column = 0; column < width; ++column) {
                const double left = static_cast<double>(column) * panorama.width() / width;
                const double right = static_cast<double>(column + 1) * panorama.width() / width;
                glm::dvec3 sum(0.0);
                double weights = 0.0;
                for (int i = static_cast<int>(left); i < right && i < panorama.width(); ++i) {
                    const double weight =
                        std::min(right, i + 1.0) - std::max(left, static_cast<double>(i));
                    sum += weight * line[static_cast<std::size_t>(i)];
                    weights += weight;
                }
                image.at(column, row) = glm::vec3(sum / (bands * weights));
            }
        }
    });
    return image;
}

/// CubeMap::radiance in few instructions where all four texels are on one face.
class LookUp {
public:
    explicit LookUp(const CubeMap& cube)
        : cube_(cube), half_(0.5f * static_cast<float>(cube.faceSize())) {
        for (const CubeFace face : kCubeFaces)
            faces_[static_cast<std::size_t>(face)] = cube.texels(face).data();
    }

    [[nodiscard]] Float4 operator()(glm::vec3 direction) const noexcept {
        const CubePoint point = cubeFromDirection(direction);
        const float u = point.s * half_ + (half_ - 0.5f), v = point.t * half_ + (half_ - 0.5f);
        const int size = cube_.faceSize();
        // The last load reads one float beyond its texel: not where that is the last of all.
        if (!(u >= 0.0f && v >= 0.0f && u < static_cast<float>(size - 2) &&
              v < static_cast<float>(size - 1)))
            return float4(cube_.radiance(direction));
        const int column = static_cast<int>(u), row = static_cast<int>(v);
        const glm::vec3* const above =
            faces_[static_cast<std::size_t>(point.face)] +
            static_cast<std::size_t>(row) * static_cast<std::size_t>(size) + column;
        const glm::vec3* const below = above + size;
        const float right = u - static_cast<float>(column), down = v - static_cast<float>(row);
        Float4 a = loadFloat4(above), b = loadFloat4(below);
        a += right * (loadFloat4(above + 1) - a);
        b += right * (loadFloat4(below + 1) - b);
        return a + down * (b - a);
    }

private:
    const CubeMap& cube_;
    float half_;
    std::array<const glm::vec3*, 6> faces_;
};

/// Scales the pixels within each pixel of `means` by one factor, so that their mean is that pixel:
/// what unblurred leaves where light and dark lie too close together. Exact where whole pixels fit.
void scaleToMeans(Image& image, const Image& means, const Progress& progress) {
    const Image found = shrunkPanorama(image, means.width(), Progress());
    (void)parallelFor(0, image.height(), 32, progress, [&](int begin, int end) {
        for (int row = begin; row < end; ++row) {
            // The pixel in which this one's middle lies, in integers.
            const int below =
                static_cast<int>((2ll * row + 1) * means.height() / (2 * image.height()));
            for (int column = 0; column < image.width(); ++column) {
                const int beside =
                    static_cast<int>((2ll * column + 1) * means.width() / (2 * image.width()));
                const glm::vec3& wanted = means.at(beside, below);
                const glm::vec3& is = found.at(beside, below);
                glm::vec3& pixel = image.at(column, row);
                for (int c = 0; c < 3; ++c)
                    if (is[c] > 0.0f && is[c] != wanted[c]) pixel[c] *= wanted[c] / is[c];
            }
        }
    });
}

}  // namespace

Image resizedPanorama(const Image& panorama, int width, const Progress& progress) {
    if (width == panorama.width() && std::max(1, width / 2) == panorama.height()) return panorama;
    if (width < panorama.width()) return shrunkPanorama(panorama, width, progress);
    Image grown = grownPanorama(unblurred(panorama), width, partOf(progress, 0.0f, 0.5f));
    scaleToMeans(grown, panorama, partOf(progress, 0.5f, 1.0f));
    return grown;
}

Image panoramaFromCube(const CubeMap& cube, int width, const Progress& progress) {
    const int height = std::max(1, width / 2);
    if (isConstant(cube)) {
        Image image(width, height);
        std::fill(image.pixels().begin(), image.pixels().end(),
                  cube.texels(CubeFace::posX).front());
        return image;
    }
    // Means of 3 x 3 look-ups. Longitudes and colatitudes of all columns and rows of them:
    std::vector<glm::vec2> longitudes, colatitudes;  // sine, cosine
    for (int i = 0; i < 3 * width; ++i) {
        const double angle = 2.0 * kPi * ((i + 0.5) / (3.0 * width) - 0.5);
        longitudes.emplace_back(std::sin(angle), std::cos(angle));
    }
    for (int i = 0; i < 3 * height; ++i) {
        const double angle = kPi * (i + 0.5) / (3.0 * height);
        colatitudes.emplace_back(std::sin(angle), std::cos(angle));
    }
    const LookUp radiance(cube);
    Image image(width, height);
    (void)parallelFor(0, height, 8, progress, [&](int begin, int end) {
        for (int row = begin; row < end; ++row)
            for (int column = 0; column < width; ++column) {
                Float4 sum{};
                for (int i = 0; i < 9; ++i) {
                    const glm::vec2 down = colatitudes[static_cast<std::size_t>(3 * row + i / 3)];
                    const glm::vec2 across =
                        longitudes[static_cast<std::size_t>(3 * column + i % 3)];
                    sum += radiance({down.x * across.x, down.y, -down.x * across.y});
                }
                image.at(column, row) = vec3FromFloat4(sum / 9.0f);
            }
    });
    return image;
}

Image panoramaWithMeansOf(const CubeMap& cube, int width, const Progress& progress) {
    // Of faces finer than the panorama means are compared.
    const int size = std::min(cube.faceSize(), width), finer = std::min(cube.faceSize(), 2 * width);
    const CubeMap given = size < cube.faceSize() ? shrunkCube(cube, size) : cube;
    Image start = unblurred(panoramaFromCube(given, width, partOf(progress, 0.0f, 0.3f)));
    if (isConstant(cube)) return start;
    constexpr int kSteps = 8;
    return afterSteps(kSteps, std::move(start), [&](Image& image, float done, float next) {
        const CubeMap made = cubeFromEquirect(image, finer);
        CubeMap ratios = finer > size ? shrunkCube(made, size) : made;
        for (const CubeFace face : kCubeFaces)
            for (std::size_t i = 0; i < ratios.texels(face).size(); ++i)
                ratios.texels(face)[i] = ratioOf(given.texels(face)[i], ratios.texels(face)[i]);
        const LookUp ratio(ratios);
        return parallelFor(
            0, image.height(), 8, partOf(progress, 0.3f + 0.7f * done, 0.3f + 0.7f * next),
            [&](int begin, int end) {
                for (int row = begin; row < end; ++row)
                    for (int column = 0; column < width; ++column) {
                        const glm::vec2 place = (glm::vec2(column, row) + 0.5f) /
                                                glm::vec2(image.width(), image.height());
                        image.at(column, row) *=
                            vec3FromFloat4(ratio(directionFromEquirect(place)));
                    }
            });
    });
}

}  // namespace tukor
