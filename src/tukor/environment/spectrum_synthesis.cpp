#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "tukor/base/error.h"
#include "tukor/base/parallel.h"
#include "tukor/environment/equirect_rows.h"
#include "tukor/environment/float4.h"
#include "tukor/environment/legendre.h"
#include "tukor/environment/row_transform.h"
#include "tukor/environment/spectrum.h"

namespace tukor {

namespace {

constexpr double kPi = std::numbers::pi;

Double4 loaded(const double* from) {
    return Double4{from[0], from[1], from[2], from[3]};
}

/// Radiance without the mean at the pixel centres of a panorama of `height` rows, a power of two.
class Grid {
public:
    Grid(const Spectrum& spectrum, std::span<const double> factors, int height)
        : height_(height),
          width_(2 * height),
          pairs_(height / 2),
          degree_(std::min(static_cast<int>(factors.size()) - 1, spectrum.degree())),
          values_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_)),
          folded_(static_cast<std::size_t>(degree_ + 1) * 12 * paddedPairs(), 0.0f) {
        parallelFor(0, degree_ + 1, 4, [&](int begin, int end) {
            for (int m = begin; m < end; ++m) sumDegrees(spectrum, factors, m);
        });
        const RowTransform transform(width_);
        parallelFor(0, (pairs_ + 7) / 8, 1, [&](int begin, int end) {
            std::vector<Float8> real(static_cast<std::size_t>(width_)), imaginary(real);
            for (int group = begin; group < end; ++group)
                for (int channel = 0; channel < 3; ++channel)
                    sumOrders(transform, group, channel, real, imaginary);
        });
    }

    [[nodiscard]] int height() const noexcept { return height_; }
    [[nodiscard]] int width() const noexcept { return width_; }

    /// Any column, wrapping; rows over a pole are on the far side. Within 4 rows of the picture.
    [[nodiscard]] Float4 at(int column, int row) const noexcept {
        if (row < 0 || row >= height_) {
            row = row < 0 ? -1 - row : 2 * height_ - 1 - row;
            column += width_ / 2;
        }
        return values_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
                       static_cast<std::size_t>(column & (width_ - 1))];
    }

private:
    [[nodiscard]] std::size_t paddedPairs() const noexcept {
        return (static_cast<std::size_t>(pairs_) + 7) / 8 * 8;
    }

    [[nodiscard]] float* folded(int order, int channel) noexcept {
        return folded_.data() + (static_cast<std::size_t>(order) * 3 + channel) * 4 * paddedPairs();
    }

    /// Of one order, the Fourier coefficients of the rows above the horizon and of their mirror
    /// images.
    void sumDegrees(const Spectrum& spectrum, std::span<const double> factors, int order) {
        const LegendreOrder legendre(order, degree_);
        for (int first = 0; first < pairs_; first += 8) {
            double cosines[8], values[8];
            double most = 0.0;
            for (int lane = 0; lane < 8; ++lane) {
                const double theta = kPi * (std::min(first + lane, pairs_ - 1) + 0.5) / height_;
                cosines[lane] = std::cos(theta);
                values[lane] = legendre.first(std::sin(theta));
                most = std::max(most, values[lane]);
            }
            const Double4 x[2] = {loaded(cosines), loaded(cosines + 4)};
            Double4 p[2] = {loaded(values), loaded(values + 4)};
            Double4 previous[2] = {};
            Double4 even[6][2] = {}, odd[6][2] = {};
            for (int l = order; l <= degree_ && most > 0.0; ++l) {
                const Spectrum::Coefficient& coefficient = spectrum.at(l, order);
                auto& sums = (l - order) % 2 == 0 ? even : odd;
                const double factor = factors[static_cast<std::size_t>(l)];
                const double rise = legendre.rise[static_cast<std::size_t>(l + 1)];
                const double fall = legendre.fall[static_cast<std::size_t>(l + 1)];
                for (int half = 0; half < 2; ++half) {
                    const Double4 scaled = factor * p[half];
                    for (std::size_t i = 0; i < 6; ++i) sums[i][half] += coefficient[i] * scaled;
                    const Double4 next = rise * x[half] * p[half] - fall * previous[half];
                    previous[half] = p[half];
                    p[half] = next;
                }
            }
            for (int channel = 0; channel < 3; ++channel) {
                float* const target = folded(order, channel) + first;
                for (int lane = 0; lane < 8; ++lane)
                    for (int part = 0; part < 2; ++part) {
                        const double e = even[2 * channel + part][lane / 4][lane % 4];
                        const double o = odd[2 * channel + part][lane / 4][lane % 4];
                        target[static_cast<std::size_t>(part) * paddedPairs() + lane] =
                            static_cast<float>(e + o);
                        target[static_cast<std::size_t>(part + 2) * paddedPairs() + lane] =
                            static_cast<float>(e - o);
                    }
            }
        }
    }

    void sumOrders(const RowTransform& transform, int group, int channel, std::span<Float8> real,
                   std::span<Float8> imaginary) {
        std::fill(real.begin(), real.end(), Float8{});
        std::fill(imaginary.begin(), imaginary.end(), Float8{});
        const int first = 8 * group;
        for (int m = 0; m <= degree_; ++m) {
            const float* const source = folded(m, channel) + first;
            const auto load = [&](std::size_t part) {
                Float8 value;
                std::memcpy(&value, source + part * paddedPairs(), sizeof value);
                return value;
            };
            const Float8 a = load(0), b = load(1), c = load(2), d = load(3);
            const double phase = kPi * m / width_;  // pixel centres lie half a pixel in
            const auto cosine = static_cast<float>(std::cos(phase));
            const auto sine = static_cast<float>(std::sin(phase));
            const Float8 upperReal = a * cosine - b * sine, upperImaginary = a * sine + b * cosine;
            const Float8 lowerReal = c * cosine - d * sine, lowerImaginary = c * sine + d * cosine;
            // upper + i lower, both real: what stands at m stands conjugated at -m.
            const auto k = static_cast<std::size_t>(m);
            if (m == 0) {
                real[0] = upperReal;
                imaginary[0] = lowerReal;
                continue;
            }
            const auto mirror = static_cast<std::size_t>(width_ - m);
            real[k] = upperReal - lowerImaginary;
            imaginary[k] = upperImaginary + lowerReal;
            real[mirror] = upperReal + lowerImaginary;
            imaginary[mirror] = lowerReal - upperImaginary;
        }
        transform.inverse(real, imaginary);
        for (int lane = 0; lane < std::min(8, pairs_ - first); ++lane) {
            const auto width = static_cast<std::size_t>(width_);
            Float4* const upper = &values_[static_cast<std::size_t>(first + lane) * width];
            Float4* const lower =
                &values_[static_cast<std::size_t>(height_ - 1 - first - lane) * width];
            for (std::size_t i = 0; i < width; ++i) {
                upper[i][channel] = real[i][lane];
                lower[i][channel] = imaginary[i][lane];
            }
        }
    }

    int height_;
    int width_;
    int pairs_;
    int degree_;
    std::vector<Float4> values_;
    std::vector<float> folded_;  // [order][channel][upper re, upper im, lower re, lower im][pair]
};

/// Weights of four equally spaced samples at a place `t` in [0, 1) after the second: Lagrange's
/// cubic.
std::array<float, 4> cubicWeights(float t) {
    return {-t * (t - 1.0f) * (t - 2.0f) / 6.0f, (t + 1.0f) * (t - 1.0f) * (t - 2.0f) / 2.0f,
            -(t + 1.0f) * t * (t - 2.0f) / 2.0f, (t + 1.0f) * t * (t - 1.0f) / 6.0f};
}

/// Rows of a grid that a cubic can follow: four samples or more to the shortest wave that still
/// matters.
int gridHeight(std::span<const double> factors) {
    int degree = static_cast<int>(factors.size()) - 1;
    while (degree > 0 && std::abs(factors[static_cast<std::size_t>(degree)]) < 1e-3) --degree;
    const int wanted = std::max({32, static_cast<int>(factors.size()) + 1, 2 * degree});
    return static_cast<int>(std::bit_ceil(static_cast<unsigned>(wanted)));
}

}  // namespace

CubeMap cubeFromSpectrum(const Spectrum& spectrum, std::span<const double> factors, int faceSize) {
    const Grid grid(spectrum, factors, gridHeight(factors));
    const Float4 mean = float4(glm::vec3(spectrum.mean * factors[0]));
    CubeMap cube(faceSize);
    const auto size = static_cast<std::size_t>(faceSize);
    const float step = 2.0f / static_cast<float>(faceSize);
    parallelFor(0, 6 * faceSize, 16, [&](int begin, int end) {
        EquirectRow places(grid.width(), grid.height(), faceSize);
        for (int line = begin; line < end; ++line) {
            const auto face = static_cast<CubeFace>(line / faceSize);
            const int row = line % faceSize;
            places.place(face, (static_cast<float>(row) + 0.5f) * step - 1.0f, 0.5f * step - 1.0f,
                         step);
            glm::vec3* texel = &cube.texels(face)[static_cast<std::size_t>(row) * size];
            for (std::size_t i = 0; i < size; ++i) {
                const float x = places.columns[i] + 0.5f, y = places.rows[i] + 0.5f;
                const int column = static_cast<int>(x) - 1, above = static_cast<int>(y) - 1;
                const auto across = cubicWeights(x - static_cast<float>(column + 1));
                const auto down = cubicWeights(y - static_cast<float>(above + 1));
                Float4 sum{};
                for (int j = 0; j < 4; ++j) {
                    Float4 part{};
                    for (int k = 0; k < 4; ++k)
                        part += across[static_cast<std::size_t>(k)] *
                                grid.at(column - 1 + k, above - 1 + j);
                    sum += down[static_cast<std::size_t>(j)] * part;
                }
                texel[i] = vec3FromFloat4(max(sum + mean, Float4{}));
            }
        }
    });
    return cube;
}

Image panoramaFromSpectrum(const Spectrum& spectrum, std::span<const double> factors, int height) {
    TUKOR_ASSERT(std::has_single_bit(static_cast<unsigned>(height)) &&
                 height > static_cast<int>(factors.size()));
    const Grid grid(spectrum, factors, height);
    Image image(grid.width(), height);
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < grid.width(); ++column)
            image.at(column, row) =
                glm::vec3(spectrum.mean * factors[0]) + vec3FromFloat4(grid.at(column, row));
    return image;
}

}  // namespace tukor
