#include "tukor/environment/unblurred.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "tukor/base/parallel.h"
#include "tukor/environment/float4.h"

namespace tukor {

namespace {

/// Weights of the two pixels at distance 1, 2, ... on either side of one in the middle, which gets
/// what is missing from 1.
template <std::size_t kReach>
using Kernel = std::array<float, kReach>;

constexpr Kernel<1> kBlur = {0.125f};

/// The inverse of kBlur, whose terms fall off as r^k with r = sqrt(8) - 3.
Kernel<6> inverseOfBlur() {
    Kernel<6> kernel;
    for (std::size_t k = 0; k < kernel.size(); ++k)
        kernel[k] = static_cast<float>(std::sqrt(2.0) *
                                       std::pow(std::sqrt(8.0) - 3.0, static_cast<double>(k + 1)));
    return kernel;
}

/// Along both axes; around, and over the poles to the far side. As differences, so that one value
/// everywhere stays that value exactly. `use(column, row, sum)` takes the results.
template <std::size_t kReach, class Use>
void convolve(const Image& image, const Kernel<kReach>& kernel, const Use& use) {
    const int width = image.width(), height = image.height();
    constexpr int kPad = static_cast<int>(kReach);
    parallelFor(0, height, 16, [&](int begin, int end) {
        std::vector<Float4> line(static_cast<std::size_t>(width + 2 * kPad));
        for (int row = begin; row < end; ++row) {
            std::array<const glm::vec3*, 2 * kReach + 1> rows;
            std::array<bool, 2 * kReach + 1> over{};
            for (int k = -kPad; k <= kPad; ++k) {
                int at = row + k;
                const auto i = static_cast<std::size_t>(k + kPad);
                // Pictures lower than the kernel are met from both sides in turn.
                while (at < 0 || at >= height) {
                    at = at < 0 ? -1 - at : 2 * height - 1 - at;
                    over[i] = !over[i];
                }
                rows[i] = &image.at(0, at);
            }
            for (int column = 0; column < width; ++column) {
                const int far = column < width / 2 ? column + width / 2 : column - width / 2;
                const auto at = [&](int k) {
                    const auto i = static_cast<std::size_t>(k + kPad);
                    return float4(rows[i][over[i] ? far : column]);
                };
                const Float4 middle = at(0);
                Float4 sum = middle;
                for (int k = 1; k <= kPad; ++k)
                    sum += kernel[static_cast<std::size_t>(k - 1)] *
                           ((at(-k) - middle) + (at(k) - middle));
                line[static_cast<std::size_t>(column + kPad)] = sum;
            }
            for (int k = 0; k < kPad; ++k) {
                const int left = ((k - kPad) % width + width) % width, right = k % width;
                line[static_cast<std::size_t>(k)] = line[static_cast<std::size_t>(left + kPad)];
                line[static_cast<std::size_t>(width + kPad + k)] =
                    line[static_cast<std::size_t>(right + kPad)];
            }
            for (int column = 0; column < width; ++column) {
                const Float4* const middle = &line[static_cast<std::size_t>(column + kPad)];
                Float4 sum = *middle;
                for (int k = 1; k <= kPad; ++k)
                    sum += kernel[static_cast<std::size_t>(k - 1)] *
                           ((middle[-k] - *middle) + (middle[k] - *middle));
                use(column, row, sum);
            }
        }
    });
}

}  // namespace

Image sharpened(const Image& means) {
    Image result(means.width(), means.height());
    convolve(means, inverseOfBlur(), [&](int column, int row, Float4 sum) {
        result.at(column, row) = vec3FromFloat4(sum);
    });
    return result;
}

Image unblurred(const Image& means) {
    Image result = sharpened(means);
    Image ratios(means.width(), means.height());
    // What the steps below multiply must not be 0, nor far from it.
    for (std::size_t i = 0; i < result.pixels().size(); ++i)
        result.pixels()[i] = glm::max(result.pixels()[i], 0.125f * means.pixels()[i]);
    // Where the inverse was positive all ratios are 1; elsewhere each step keeps the sum and comes
    // nearer. Four leave a thousandth of photographs.
    constexpr int kSteps = 4;
    for (int step = 0; step < kSteps; ++step) {
        convolve(result, kBlur, [&](int column, int row, Float4 blurred) {
            const glm::vec3& mean = means.at(column, row);
            glm::vec3& ratio = ratios.at(column, row);
            for (int c = 0; c < 3; ++c) ratio[c] = blurred[c] > 0.0f ? mean[c] / blurred[c] : 1.0f;
        });
        convolve(ratios, kBlur, [&](int column, int row, Float4 blurred) {
            result.at(column, row) *= vec3FromFloat4(blurred);
        });
    }
    return result;
}

}  // namespace tukor
