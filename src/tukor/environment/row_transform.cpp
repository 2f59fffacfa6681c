#include "tukor/environment/row_transform.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "tukor/base/error.h"

namespace tukor {

RowTransform::RowTransform(int size)
    : size_(size),
      cosine_(static_cast<std::size_t>(size) / 2),
      sine_(static_cast<std::size_t>(size) / 2),
      reversed_(static_cast<std::size_t>(size)) {
    TUKOR_ASSERT(size >= 2 && (size & (size - 1)) == 0);
    for (std::size_t k = 0; k < cosine_.size(); ++k) {
        const double angle = -2.0 * std::numbers::pi * static_cast<double>(k) / size;
        cosine_[k] = static_cast<float>(std::cos(angle));
        sine_[k] = static_cast<float>(std::sin(angle));
    }
    for (int i = 1; i < size; ++i)
        reversed_[static_cast<std::size_t>(i)] =
            reversed_[static_cast<std::size_t>(i / 2)] / 2 + (i % 2) * (size / 2);
}

void RowTransform::forward(std::span<Float8> real, std::span<Float8> imaginary) const noexcept {
    const auto size = static_cast<std::size_t>(size_);
    for (std::size_t i = 0; i < size; ++i) {
        const auto j = static_cast<std::size_t>(reversed_[i]);
        if (j <= i) continue;
        std::swap(real[i], real[j]);
        std::swap(imaginary[i], imaginary[j]);
    }
    for (std::size_t half = 1; half < size; half *= 2) {
        const std::size_t stride = size / (2 * half);
        for (std::size_t block = 0; block < size; block += 2 * half)
            for (std::size_t k = 0; k < half; ++k) {
                const float c = cosine_[k * stride], s = sine_[k * stride];
                const std::size_t a = block + k, b = a + half;
                const Float8 re = real[b] * c - imaginary[b] * s;
                const Float8 im = real[b] * s + imaginary[b] * c;
                real[b] = real[a] - re;
                imaginary[b] = imaginary[a] - im;
                real[a] += re;
                imaginary[a] += im;
            }
    }
}

}  // namespace tukor
