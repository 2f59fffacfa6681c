#include "tukor/environment/equirect_rows.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

#include "tukor/environment/simd.h"

namespace tukor {

namespace {

constexpr float kPi = std::numbers::pi_v<float>;

// Eight samples at once, spelled out: compilers give up on the selections below.

inline Float8 absolute(Float8 x) {
    return x < 0.0f ? -x : x;
}

inline Float8 root(Float8 x) {
    Float8 result;
    for (int i = 0; i < 8; ++i) result[i] = std::sqrt(x[i]);
    return result;
}

/// atan(low / high) for 0 <= low <= high, high > 0; right to 2e-7. [Moshier 1989, atanf]
inline Float8 atanOfRatio(Float8 low, Float8 high) {
    const auto large = low > 0.41421356f * high;  // tan(pi / 8): beyond it the series is too slow
    const Float8 x = (large ? low - high : low) / (large ? low + high : high);
    const Float8 x2 = x * x;
    const Float8 value =
        (((8.05374449538e-2f * x2 - 1.38776856032e-1f) * x2 + 1.99777106478e-1f) * x2 -
         3.33329491539e-1f) *
            x2 * x +
        x;
    return large ? value + 0.25f * kPi : value;
}

/// std::atan2, but 0 at (0, 0) whatever the signs.
inline Float8 fastAtan2(Float8 y, Float8 x) {
    const Float8 absX = absolute(x), absY = absolute(y);
    const auto steep = absY > absX;
    const Float8 high = steep ? absY : absX;
    const Float8 angle = atanOfRatio(steep ? absX : absY, high > 1e-30f ? high : high + 1e-30f);
    const Float8 quadrant = steep ? 0.5f * kPi - angle : angle;
    const Float8 half = x < 0.0f ? kPi - quadrant : quadrant;
    return y < 0.0f ? -half : half;
}

}  // namespace

void EquirectRow::place(CubeFace face, float t, float firstS, float stepS) noexcept {
    const glm::vec3 right =
        directionFromCube({face, 1.0f, 0.0f}) - directionFromCube({face, 0.0f, 0.0f});
    const glm::vec3 start = directionFromCube({face, 0.0f, t});
    const float columnScale = width_ / (2.0f * kPi);
    const float rowScale = height_ / kPi;
    const std::size_t count = columns.size();  // a multiple of eight
    for (std::size_t first = 0; first < count; first += 8) {
        const auto base = static_cast<float>(first);
        const Float8 s = firstS + stepS * (base + Float8{0, 1, 2, 3, 4, 5, 6, 7});
        const Float8 x = start.x + s * right.x;
        const Float8 y = start.y + s * right.y;
        const Float8 z = start.z + s * right.z;
        Float8 column = (fastAtan2(x, -z) + kPi) * columnScale;
        Float8 row = fastAtan2(root(x * x + z * z), y) * rowScale;
        column = column < width_ ? column : column * 0.0f + width_;
        row = row < height_ ? row : row * 0.0f + height_;
        // The vectors hold a multiple of eight: a copy of known size is one instruction.
        std::memcpy(columns.data() + first, &column, sizeof column);
        std::memcpy(rows.data() + first, &row, sizeof row);
    }
}

}  // namespace tukor
