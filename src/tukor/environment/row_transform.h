// Fourier transforms of eight rows at once.
#pragma once
#include <span>
#include <vector>

#include "tukor/environment/simd.h"

namespace tukor {

/// Complex transforms of length `size`, a power of two, in place; lane k of each element belongs to
/// row k. Forward has exp(-i), neither direction scales.
class RowTransform {
public:
    explicit RowTransform(int size);

    [[nodiscard]] int size() const noexcept { return size_; }
    void forward(std::span<Float8> real, std::span<Float8> imaginary) const noexcept;
    void inverse(std::span<Float8> real, std::span<Float8> imaginary) const noexcept {
        forward(imaginary, real);  // swapping the two conjugates before and after
    }

private:
    int size_;
    std::vector<float> cosine_;  // of -2 pi k / size, k below size / 2
    std::vector<float> sine_;
    std::vector<int> reversed_;  // bits of the index, reversed
};

}  // namespace tukor
