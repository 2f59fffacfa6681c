#include "tukor/image/display.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "tukor/image/tonemap.h"

namespace tukor {

static_assert(static_cast<int>(Tonemap::none) == tonemap::kNone &&
              static_cast<int>(Tonemap::reinhard) == tonemap::kReinhard &&
              static_cast<int>(Tonemap::aces) == tonemap::kAces &&
              static_cast<int>(Tonemap::agx) == tonemap::kAgx &&
              static_cast<int>(Tonemap::neutral) == tonemap::kNeutral);

namespace {

double linearFromCode(double code) {
    const double c = code / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

// A component's code from the top bits of its float: 256 buckets for each power of two between
// 2^-13, below the first code's threshold, and 1. They are narrower than the codes, so that a
// bucket holds one threshold at most and one comparison decides.
constexpr std::uint32_t kFirstBits = (127u - 13u) << 23;
constexpr int kShift = 15;

struct Srgb8Table {
    std::array<float, 257> threshold{};  // the least value of each code; none reaches the last
    std::array<std::uint8_t, 13 * 256> first{};  // the code at the low end of each bucket

    Srgb8Table() {
        for (int code = 1; code < 256; ++code)
            threshold[static_cast<std::size_t>(code)] =
                static_cast<float>(linearFromCode(code - 0.5));
        threshold[256] = 2.0f;
        for (std::size_t i = 0; i < first.size(); ++i) {
            const std::uint32_t bits = kFirstBits + (static_cast<std::uint32_t>(i) << kShift);
            float value = 0.0f;
            std::memcpy(&value, &bits, sizeof value);
            first[i] = static_cast<std::uint8_t>(
                std::upper_bound(threshold.begin(), threshold.end(), value) - threshold.begin() -
                1);
        }
    }
};

}  // namespace

glm::vec3 displayed(glm::vec3 radiance, Tonemap tonemap, float exposureFactor) {
    // Above 1e6 every tone mapper is white; infinity would become NaN in some.
    glm::vec3 L;
    for (int c = 0; c < 3; ++c) {
        const float value = radiance[c] * exposureFactor;
        L[c] = value > 0.0f ? std::min(value, 1e6f) : 0.0f;
    }
    return glm::clamp(tonemap::mapped(static_cast<int>(tonemap), L), glm::vec3(0.0f),
                      glm::vec3(1.0f));
}

std::uint8_t srgb8(float linear) noexcept {
    static const Srgb8Table table;
    constexpr float kLeast = 1.0f / 8192.0f;         // 2^-13, code 0
    constexpr float kMost = 1.0f - 1.0f / 16777216;  // the float below 1
    const float clipped = linear > kLeast ? std::min(linear, kMost) : kLeast;
    std::uint32_t bits = 0;
    std::memcpy(&bits, &clipped, sizeof bits);
    const std::size_t code = table.first[(bits - kFirstBits) >> kShift];
    return static_cast<std::uint8_t>(code + (clipped >= table.threshold[code + 1] ? 1 : 0));
}

const std::array<float, 256>& linearFromSrgb8() noexcept {
    static const std::array<float, 256> table = [] {
        std::array<float, 256> values{};
        for (std::size_t code = 0; code < 256; ++code)
            values[code] = static_cast<float>(linearFromCode(static_cast<double>(code)));
        return values;
    }();
    return table;
}

}  // namespace tukor
