#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "tukor/base/error.h"
#include "tukor/base/parallel.h"
#include "tukor/environment/legendre.h"
#include "tukor/environment/row_transform.h"
#include "tukor/environment/spectrum.h"

namespace tukor {

namespace {

constexpr double kPi = std::numbers::pi;

/// Fourier coefficients of all rows: for each order and channel the sum and the difference of a row
/// and its mirror image below the horizon. P_lm is even or odd in cos theta, so each needs one of
/// the two.
class FoldedRows {
public:
    enum Part { evenReal, evenImaginary, oddReal, oddImaginary };

    FoldedRows(int degree, int pairs)
        : pairs_((static_cast<std::size_t>(pairs) + 7) / 8 * 8),
          values_(static_cast<std::size_t>(degree + 1) * 12 * pairs_, 0.0f) {}

    /// One value for each pair of rows, padded with zeros to a multiple of eight.
    [[nodiscard]] float* at(int order, int channel, Part part) noexcept {
        return values_.data() +
               ((static_cast<std::size_t>(order) * 3 + channel) * 4 + part) * pairs_;
    }

    [[nodiscard]] int paddedPairs() const noexcept { return static_cast<int>(pairs_); }

private:
    std::size_t pairs_;
    std::vector<float> values_;
};

glm::dvec3 meanOf(const Image& panorama) {
    const int width = panorama.width(), height = panorama.height();
    std::vector<glm::dvec3> rows(static_cast<std::size_t>(height));
    parallelFor(0, height, 64, [&](int begin, int end) {
        for (int row = begin; row < end; ++row) {
            glm::dvec3 sum(0.0);
            for (int column = 0; column < width; ++column)
                sum += glm::dvec3(panorama.at(column, row));
            rows[static_cast<std::size_t>(row)] =
                (std::cos(kPi * row / height) - std::cos(kPi * (row + 1) / height)) * sum;
        }
    });
    glm::dvec3 sum(0.0);
    for (const glm::dvec3& row : rows) sum += row;
    return sum / (2.0 * width);
}

/// Means of a row over `target.size()` equal spans, minus `mean`, into one lane.
void spanMeans(const Image& panorama, int row, int channel, double mean, std::span<Float8> target,
               int lane) {
    const int width = panorama.width();
    const int spans = static_cast<int>(target.size());
    const float* const pixels = &panorama.at(0, row)[channel];
    const auto offset = static_cast<float>(mean);
    if (width % spans == 0) {
        const int box = width / spans;
        const float scale = 1.0f / static_cast<float>(box);
        for (int i = 0; i < spans; ++i) {
            float sum = 0.0f;
            for (int k = 0; k < box; ++k) sum += pixels[3 * (i * box + k)] - offset;
            target[static_cast<std::size_t>(i)][lane] = scale * sum;
        }
        return;
    }
    const double step = static_cast<double>(width) / spans;
    for (int i = 0; i < spans; ++i) {
        const double begin = i * step, end = begin + step;
        double sum = 0.0;
        for (int k = static_cast<int>(begin); k < end && k < width; ++k)
            sum += (std::min(end, k + 1.0) - std::max(begin, static_cast<double>(k))) *
                   static_cast<double>(pixels[3 * k] - offset);
        target[static_cast<std::size_t>(i)][lane] = static_cast<float>(sum / step);
    }
}

/// The Fourier coefficient of order m of pixels as areas, over that of the means of spans as
/// points.
double spanFactor(int m, int width, int spans) {
    if (m == 0) return 1.0;
    const double x = kPi * m / spans;
    if (width % spans != 0) return x / std::sin(x);  // spans finer than the pixels
    const double box = static_cast<double>(width) / spans, y = kPi * m / width;
    return std::sin(y) / y * (box > 1.0 ? box * std::sin(y) / std::sin(x) : 1.0);
}

FoldedRows transformRows(const Image& panorama, int degree, const glm::dvec3& mean) {
    const int height = panorama.height();
    const int pairs = (height + 1) / 2;
    const int width = panorama.width();
    const auto powerAbove = [](int n) {
        return static_cast<int>(std::bit_ceil(static_cast<unsigned>(std::max(n, 2))));
    };
    // Pixels of a power of two are used as they are, or in groups four times finer than the
    // shortest wave. Others are cut anew, finer than either, so that little aliases back.
    const bool whole = width >= 2 && std::has_single_bit(static_cast<unsigned>(width));
    const int spans = whole ? std::min(width, powerAbove(std::max(4 * degree, 2048)))
                            : powerAbove(std::max(2 * width, 4 * degree));
    const RowTransform transform(spans);
    FoldedRows folded(degree, pairs);
    parallelFor(0, (pairs + 7) / 8, 1, [&](int begin, int end) {
        std::vector<Float8> real(static_cast<std::size_t>(spans)), imaginary(real);
        for (int group = begin; group < end; ++group)
            for (int channel = 0; channel < 3; ++channel) {
                const int first = 8 * group, count = std::min(8, pairs - first);
                std::fill(real.begin(), real.end(), Float8{});
                std::fill(imaginary.begin(), imaginary.end(), Float8{});
                // Two real rows are one complex one: upper + i lower.
                for (int lane = 0; lane < count; ++lane) {
                    spanMeans(panorama, first + lane, channel, mean[channel], real, lane);
                    spanMeans(panorama, height - 1 - first - lane, channel, mean[channel],
                              imaginary, lane);
                }
                transform.forward(real, imaginary);
                for (int m = 0; m <= degree; ++m) {
                    const auto k = static_cast<std::size_t>(m % spans);
                    const auto mirror =
                        (static_cast<std::size_t>(spans) - k) % static_cast<std::size_t>(spans);
                    const Float8 upperReal = 0.5f * (real[k] + real[mirror]);
                    const Float8 upperImaginary = 0.5f * (imaginary[k] - imaginary[mirror]);
                    const Float8 lowerReal = 0.5f * (imaginary[k] + imaginary[mirror]);
                    const Float8 lowerImaginary = 0.5f * (real[mirror] - real[k]);
                    // Half a span of phase, since the first begins at 0; and the integral over a
                    // pixel instead of its value, after undoing what averaging into spans did.
                    const double x = kPi * m / spans;
                    const double scale = 2.0 * kPi / spans * spanFactor(m, width, spans);
                    const auto c = static_cast<float>(scale * std::cos(x));
                    const auto s = static_cast<float>(-scale * std::sin(x));
                    const Float8 sumReal = upperReal + lowerReal;
                    const Float8 sumImaginary = upperImaginary + lowerImaginary;
                    const Float8 differenceReal = upperReal - lowerReal;
                    const Float8 differenceImaginary = upperImaginary - lowerImaginary;
                    const auto store = [&](FoldedRows::Part part, const Float8& values) {
                        float* const target = folded.at(m, channel, part) + first;
                        for (int lane = 0; lane < count; ++lane) target[lane] = values[lane];
                    };
                    store(FoldedRows::evenReal, c * sumReal - s * sumImaginary);
                    store(FoldedRows::evenImaginary, c * sumImaginary + s * sumReal);
                    store(FoldedRows::oddReal, c * differenceReal - s * differenceImaginary);
                    store(FoldedRows::oddImaginary, c * differenceImaginary + s * differenceReal);
                }
            }
    });
    return folded;
}

/// Where the Legendre functions are evaluated: Gauss points within each row above the horizon.
struct LatitudeNode {
    std::vector<double> cosine, sine, weight;  // one for each pair of rows, padded
};

std::vector<LatitudeNode> latitudeNodes(int height, int degree, int paddedPairs) {
    // Where a row is short beside the shortest wave, its middle will do; else 2 points, else 3 in
    // each part that is no longer than half that wave.
    const int points = height < 2 * degree ? 3 : height < 4 * degree ? 2 : 1;
    const int parts = std::max(1, (degree + height - 1) / height);
    constexpr double kOffsets[3][3] = {
        {0, 0, 0}, {-0.28867513459, 0.28867513459, 0}, {-0.38729833462, 0, 0.38729833462}};
    constexpr double kWeights[3][3] = {{1, 0, 0}, {0.5, 0.5, 0}, {5. / 18, 8. / 18, 5. / 18}};
    std::vector<LatitudeNode> nodes(static_cast<std::size_t>(points * parts));
    for (std::size_t index = 0; index < nodes.size(); ++index) {
        LatitudeNode& node = nodes[index];
        const auto point = index % static_cast<std::size_t>(points);
        const std::size_t part = index / static_cast<std::size_t>(points);
        const auto rule = static_cast<std::size_t>(points - 1);
        for (int pair = 0; pair < paddedPairs; ++pair) {
            const int row = std::min(pair, (height - 1) / 2);
            const double theta =
                kPi * (row + (static_cast<double>(part) + 0.5 + kOffsets[rule][point]) / parts) /
                height;
            double weight = points == 1
                                ? std::cos(kPi * row / height) - std::cos(kPi * (row + 1) / height)
                                : kWeights[rule][point] * kPi / (height * parts) * std::sin(theta);
            if (2 * pair + 1 == height) weight *= 0.5;  // the middle row is its own mirror image
            if (pair > (height - 1) / 2) weight = 0.0;
            node.cosine.push_back(std::cos(theta));
            node.sine.push_back(std::sin(theta));
            node.weight.push_back(weight);
        }
    }
    return nodes;
}

Double4 loaded(const double* from) {
    return Double4{from[0], from[1], from[2], from[3]};
}

Double4 widened(const float* from) {
    return Double4{from[0], from[1], from[2], from[3]};
}

/// Sums over the rows of P_lm times the folded rows, for one order: 6 sums a degree, four lanes
/// each.
void accumulateOrder(FoldedRows& rows, const std::vector<LatitudeNode>& nodes, int order,
                     int degree, std::vector<Double4>& sums) {
    const LegendreOrder legendre(order, degree);
    std::fill(sums.begin(), sums.end(), Double4{});
    for (int first = 0; first < rows.paddedPairs(); first += 8) {
        Double4 even[6][2], odd[6][2];
        for (int i = 0; i < 6; ++i)
            for (int half = 0; half < 2; ++half) {
                const auto part = [&](FoldedRows::Part real, FoldedRows::Part imaginary) {
                    return widened(rows.at(order, i / 2, i % 2 ? imaginary : real) + first +
                                   4 * half);
                };
                even[i][half] = part(FoldedRows::evenReal, FoldedRows::evenImaginary);
                odd[i][half] = part(FoldedRows::oddReal, FoldedRows::oddImaginary);
            }
        for (const LatitudeNode& node : nodes) {
            double values[8];
            double most = 0.0;
            for (int lane = 0; lane < 8; ++lane) {
                const auto pair = static_cast<std::size_t>(first + lane);
                values[lane] = legendre.first(node.sine[pair]) * node.weight[pair];
                most = std::max(most, values[lane]);
            }
            if (most == 0.0) continue;
            const double* const cosines = node.cosine.data() + first;
            const Double4 x[2] = {loaded(cosines), loaded(cosines + 4)};
            Double4 p[2] = {loaded(values), loaded(values + 4)};
            Double4 previous[2] = {};
            Double4* sum = sums.data();
            for (int l = order; l <= degree; ++l, sum += 6) {
                const auto& fold = (l - order) % 2 == 0 ? even : odd;
                for (int i = 0; i < 6; ++i) sum[i] += p[0] * fold[i][0] + p[1] * fold[i][1];
                const double rise = legendre.rise[static_cast<std::size_t>(l + 1)];
                const double fall = legendre.fall[static_cast<std::size_t>(l + 1)];
                for (int half = 0; half < 2; ++half) {
                    const Double4 next = rise * x[half] * p[half] - fall * previous[half];
                    previous[half] = p[half];
                    p[half] = next;
                }
            }
        }
    }
}

}  // namespace

Spectrum::Spectrum(int degree)
    : degree_(degree),
      coefficients_(static_cast<std::size_t>(degree + 1) * static_cast<std::size_t>(degree + 2) /
                    2) {
    TUKOR_ASSERT(degree >= 0 && degree <= kMaxDegree);
}

Spectrum spectrumOf(const Image& panorama, int degree) {
    TUKOR_ASSERT(!panorama.empty());
    Spectrum spectrum(degree);
    spectrum.mean = meanOf(panorama);
    FoldedRows rows = transformRows(panorama, degree, spectrum.mean);
    const auto nodes = latitudeNodes(panorama.height(), degree, rows.paddedPairs());
    parallelFor(0, degree + 1, 4, [&](int begin, int end) {
        std::vector<Double4> sums(static_cast<std::size_t>(degree + 1) * 6);
        for (int m = begin; m < end; ++m) {
            accumulateOrder(rows, nodes, m, degree, sums);
            for (int l = m; l <= degree; ++l)
                for (std::size_t i = 0; i < 6; ++i) {
                    const Double4& lanes = sums[static_cast<std::size_t>(l - m) * 6 + i];
                    spectrum.at(l, m)[i] = (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]);
                }
        }
    });
    return spectrum;
}

}  // namespace tukor
