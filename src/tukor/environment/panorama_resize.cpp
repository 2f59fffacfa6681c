// Panoramas of another size, from panoramas and from cube maps.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "tukor/base/parallel.h"
#include "tukor/environment/cube_look_up.h"
#include "tukor/environment/cube_mips.h"
#include "tukor/environment/equirect.h"
#include "tukor/environment/float4.h"
#include "tukor/environment/panorama.h"
#include "tukor/environment/unblurred.h"
#include "tukor/environment/van_cittert.h"

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

/// The one or two source pixels that a target pixel of a finer grid lies in, along one axis.
struct Overlap {
    int first, second;
    float share;  // of the second
};

std::vector<Overlap> overlaps(int sourceSize, int targetSize) {
    std::vector<Overlap> all;
    for (long long i = 0; i < targetSize; ++i) {
        const long long left = i * sourceSize, right = left + sourceSize;  // in target sizes
        const long long first = left / targetSize, over = right - (first + 1) * targetSize;
        all.push_back({static_cast<int>(first), static_cast<int>(over > 0 ? first + 1 : first),
                       over > 0 ? static_cast<float>(over) / static_cast<float>(sourceSize) : 0});
    }
    return all;
}

/// What `is` has to be divided by to become `wanted`: exactly 1 where they are equal.
glm::vec3 excessOf(glm::vec3 is, glm::vec3 wanted) noexcept {
    for (int c = 0; c < 3; ++c)
        is[c] = is[c] == wanted[c] ? 1.0f : is[c] / std::max(wanted[c], 1e-9f * is[c]);
    return is;
}

glm::vec3 withoutExcess(glm::vec3 pixel, glm::vec3 excess) noexcept {
    for (int c = 0; c < 3; ++c)
        if (excess[c] > 0.0f) pixel[c] /= excess[c];
    return pixel;
}

/// Scales the pixels within each pixel of `means` so that their mean is that pixel: what unblurred
/// leaves where light and dark lie too close together. Exact where whole pixels fit. What lies in
/// several takes the harmonic mean of their factors, which the darkest decides: so that repeated
/// scaling comes nearer quickly [Deming & Stephan 1940].
void scaleToMeans(Image& image, const Image& means, const Progress& progress) {
    Image excess = shrunkPanorama(image, means.width(), Progress());
    for (std::size_t i = 0; i < excess.pixels().size(); ++i)
        excess.pixels()[i] = excessOf(excess.pixels()[i], means.pixels()[i]);
    const std::vector<Overlap> across = overlaps(means.width(), image.width());
    const std::vector<Overlap> down = overlaps(means.height(), image.height());
    (void)parallelFor(0, image.height(), 32, progress, [&](int begin, int end) {
        for (int row = begin; row < end; ++row) {
            const Overlap& y = down[static_cast<std::size_t>(row)];
            for (int column = 0; column < image.width(); ++column) {
                const Overlap& x = across[static_cast<std::size_t>(column)];
                const auto along = [&](int j) {
                    const glm::vec3 first = excess.at(x.first, j);
                    return first + x.share * (excess.at(x.second, j) - first);
                };
                const glm::vec3 upper = along(y.first);
                glm::vec3& pixel = image.at(column, row);
                pixel = withoutExcess(pixel, upper + y.share * (along(y.second) - upper));
            }
        }
    });
}

/// A panorama of means of `across` x `across` look-ups.
Image meansOf(const CubeMap& cube, int width, int across, const Progress& progress) {
    const int height = std::max(1, width / 2);
    // Of columns and rows of look-ups: sine, cosine.
    std::vector<glm::vec2> longitudes, colatitudes;
    for (int i = 0; i < across * width; ++i) {
        const double angle = 2.0 * kPi * ((i + 0.5) / (across * static_cast<double>(width)) - 0.5);
        longitudes.emplace_back(std::sin(angle), std::cos(angle));
    }
    for (int i = 0; i < across * height; ++i) {
        const double angle = kPi * (i + 0.5) / (across * static_cast<double>(height));
        colatitudes.emplace_back(std::sin(angle), std::cos(angle));
    }
    const CubeLookUp radiance(cube);
    Image image(width, height);
    (void)parallelFor(0, height, 8, progress, [&](int begin, int end) {
        for (int row = begin; row < end; ++row)
            for (int column = 0; column < width; ++column) {
                Float4 sum{};
                for (int i = 0; i < across * across; ++i) {
                    const auto j = static_cast<std::size_t>(across * row + i / across);
                    const auto k = static_cast<std::size_t>(across * column + i % across);
                    const glm::vec2 down = colatitudes[j], beside = longitudes[k];
                    sum += radiance({down.x * beside.x, down.y, -down.x * beside.y});
                }
                image.at(column, row) = vec3FromFloat4(sum / static_cast<float>(across * across));
            }
    });
    return image;
}

/// The least and the most of 3 x 3 pixels.
struct Range {
    glm::vec3 least, most;
};

Range rangeAround(const Image& image, int column, int row) {
    const int width = image.width();
    Range range{image.at(column, row), image.at(column, row)};
    for (int j = std::max(row - 1, 0); j <= std::min(row + 1, image.height() - 1); ++j)
        for (int i = column - 1; i <= column + 1; ++i) {
            const glm::vec3 pixel = image.at((i + width) % width, j);
            range = {glm::min(range.least, pixel), glm::max(range.most, pixel)};
        }
    return range;
}

/// Whether a pixel lies no more than so many rows from a marked one, and as far beside it.
std::vector<char> widened(const std::vector<char>& marked, int width, int height, int rows) {
    std::vector<char> across(marked.size()), all(marked.size());
    const auto w = static_cast<std::size_t>(width);
    parallelFor(0, height, 16, [&](int begin, int end) {
        std::vector<int> before(w + 1);  // marked pixels of the row
        for (int row = begin; row < end; ++row) {
            const std::size_t first = static_cast<std::size_t>(row) * w;
            for (std::size_t i = 0; i < w; ++i) before[i + 1] = before[i] + marked[first + i];
            const double sine = std::sin(kPi * (row + 0.5) / height);
            const int reach = static_cast<int>(std::min(rows / sine, 0.5 * width - 1.0));
            const auto count = [&](int from, int to) {  // of columns
                return before[static_cast<std::size_t>(std::clamp(to, 0, width))] -
                       before[static_cast<std::size_t>(std::clamp(from, 0, width))];
            };
            for (int i = 0; i < width; ++i) {
                const int from = i - reach, to = i + reach + 1;
                across[first + static_cast<std::size_t>(i)] =
                    count(from, to) + count(from + width, width) + count(0, to - width) > 0;
            }
        }
    });
    parallelFor(0, height, 16, [&](int begin, int end) {
        for (int row = begin; row < end; ++row)
            for (int j = std::max(row - rows, 0); j <= std::min(row + rows, height - 1); ++j)
                for (std::size_t i = 0; i < w; ++i)
                    all[static_cast<std::size_t>(row) * w + i] |=
                        across[static_cast<std::size_t>(j) * w + i];
    });
    return all;
}

/// Where no panorama gives what is given, steps overshoot: they lose or make the light of lamps,
/// and draw dark and bright rims around them. At the former and `rows` around, where their light
/// lies, and, but for `lampsAlone`, at the latter pixels become those of `calm`, and leave the
/// range of `means` around them by at most a quarter: below, and where these are alike, above.
/// `missed`: by how much what is given is missed.
void calmDown(Image& panorama, const Image& calm, const Image& means, const Image& missed, int rows,
              bool lampsAlone) {
    constexpr float kMostMissed = 0.2f;
    const int width = panorama.width(), height = panorama.height();
    const auto forAll = [&](auto&& pixel) {
        parallelFor(0, height, 16, [&](int begin, int end) {
            for (int row = begin; row < end; ++row)
                for (int column = 0; column < width; ++column)
                    pixel(column, row,
                          static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                              static_cast<std::size_t>(column));
        });
    };
    const auto misses = [&](int column, int row, glm::vec3 level) {
        return glm::any(glm::greaterThan(missed.at(column, row), kMostMissed * level));
    };
    std::vector<char> marked(panorama.pixels().size());
    forAll([&](int column, int row, std::size_t i) {
        marked[i] = misses(column, row, rangeAround(means, column, row).most);
    });
    marked = widened(marked, width, height, rows);
    forAll([&](int column, int row, std::size_t i) {
        const auto [least, most] = rangeAround(means, column, row);
        if (!marked[i] && (lampsAlone || !misses(column, row, least))) return;
        glm::vec3& pixel = panorama.at(column, row);
        pixel = glm::max(calm.at(column, row), 0.75f * least);
        for (int c = 0; c < 3; ++c)
            if (most[c] <= 2.0f * least[c]) pixel[c] = std::min(pixel[c], 1.25f * most[c]);
    });
}

/// Also says in `stopped` whether the work was asked to stop; both must outlive what is returned.
Progress watched(const Progress& progress, bool& stopped) {
    return [&](float fraction) {
        stopped = stopped || (progress && !progress(fraction));
        return !stopped;
    };
}

}  // namespace

Image resizedPanorama(const Image& panorama, int width, const Progress& progress) {
    if (width == panorama.width() && std::max(1, width / 2) == panorama.height()) return panorama;
    if (width < panorama.width()) return shrunkPanorama(panorama, width, progress);
    Image grown = grownPanorama(unblurred(panorama), width, partOf(progress, 0.0f, 0.5f));
    const int steps = width % panorama.width() == 0 ? 1 : 16;
    for (int i = 0; i < steps; ++i) {
        const auto part = [&](int step) {
            return 0.5f + 0.5f * static_cast<float>(step) / static_cast<float>(steps);
        };
        scaleToMeans(grown, panorama, partOf(progress, part(i), part(i + 1)));
    }
    return grown;
}

Image panoramaFromCube(const CubeMap& cube, int width, const Progress& progress) {
    // Look-ups lie a third of a texel apart, or they would miss or double a lamp of one.
    const float texels = static_cast<float>(cube.faceSize()) / equirectDensity(width);
    const int across = std::clamp(static_cast<int>(std::ceil(3.0f * texels)), 3, 12);
    if (!isConstant(cube)) return meansOf(cube, width, across, progress);
    Image image(width, std::max(1, width / 2));
    std::fill(image.pixels().begin(), image.pixels().end(), cube.texels(CubeFace::posX).front());
    return image;
}

Image panoramaWithMeansOf(const CubeMap& cube, int width, const Progress& progress) {
    // Around the poles of a panorama only faces finer than it know its columns apart.
    const int size = std::min(cube.faceSize(), 2 * width);
    const int finer = std::min(cube.faceSize(), 4 * width);
    const CubeMap given = size < cube.faceSize() ? shrunkCube(cube, size) : cube;
    Image means = panoramaFromCube(given, width, partOf(progress, 0.0f, 0.1f));
    if (isConstant(cube)) return means;
    // What the panorama gives, against what is given.
    const auto compared = [&](const Image& panorama, auto&& compare) {
        CubeMap made = cubeFromEquirect(panorama, finer);
        if (finer > size) made = shrunkCube(made, size);
        for (const CubeFace face : kCubeFaces)
            for (std::size_t i = 0; i < made.texels(face).size(); ++i)
                made.texels(face)[i] = compare(made.texels(face)[i], given.texels(face)[i]);
        return made;
    };
    // Faces coarser than the panorama hold means of its pixels, which are scaled to them.
    const auto scaled = [&](const Image& panorama, const Progress& part) {
        bool stopped = false;
        Image image = meansOf(compared(panorama, excessOf), width, 1, watched(part, stopped));
        for (std::size_t i = 0; i < image.pixels().size(); ++i) {
            const glm::vec3 pixel = panorama.pixels()[i];
            image.pixels()[i] = withoutExcess(pixel, image.pixels()[i]) - pixel;
        }
        return stopped ? Image() : image;
    };
    const Image calm = unblurred(means);
    constexpr int kSteps = 8;
    const float density = equirectDensity(width);
    const auto less = [](glm::vec3 is, glm::vec3 wanted) { return wanted - is; };
    const auto missing = [&](const Image& panorama, const Progress& part) {
        bool stopped = false;
        const Progress watch = watched(part, stopped);
        const CubeMap there = compared(panorama, less);
        // Of texels as large as pixels fewer look-ups will do.
        const Image mean =
            size > width ? meansOf(there, width, 3, watch) : meansOf(there, width, 2, watch);
        return stopped ? Image() : sharpened(mean);
    };
    const bool coarse = static_cast<float>(size) < density;
    Image panorama = afterSteps(kSteps, calm, coarse ? Missing(scaled) : Missing(missing),
                                partOf(progress, 0.1f, 0.9f));
    if (panorama.empty()) return panorama;
    const auto apart = [](glm::vec3 is, glm::vec3 wanted) { return glm::abs(wanted - is); };
    // Two texels, or pixels where these are larger: so far calm pixels spread a lamp.
    const int rows =
        static_cast<int>(std::ceil(2.0f * std::max(density / static_cast<float>(size), 1.0f)));
    calmDown(panorama, calm, means,
             meansOf(compared(panorama, apart), width, 2, partOf(progress, 0.9f, 1.0f)), rows,
             coarse);
    return panorama;
}

}  // namespace tukor
