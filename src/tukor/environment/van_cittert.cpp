#include "tukor/environment/van_cittert.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "tukor/base/parallel.h"

namespace tukor {

namespace {

constexpr float kMostMomentum = 0.95f;
constexpr float kLeastPart = 0.25f;

/// What the last two steps changed: their product and the square of the earlier.
struct Changes {
    double product = 0.0;
    double square = 0.0;

    [[nodiscard]] float momentum() const noexcept {
        return square > 0.0 ? static_cast<float>(std::clamp(product / square, 0.0,
                                                            static_cast<double>(kMostMomentum)))
                            : 0.0f;
    }
};

glm::vec3 mended(glm::vec3 pixel, glm::vec3 missing) {
    return glm::max(pixel + missing, kLeastPart * pixel);
}

template <class Pixel>
void forPixels(const Image& picture, const Pixel& pixel) {
    const int count = picture.width() * picture.height();
    parallelFor(0, count, 1 << 14, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) pixel(static_cast<std::size_t>(i));
    });
}

/// Puts `now` - `then` in place of `change`, which the step before had made.
Changes compare(const Image& now, const Image& then, Image& change) {
    std::vector<Changes> rows(static_cast<std::size_t>(now.height()));
    parallelFor(0, now.height(), 16, [&](int begin, int end) {
        for (int row = begin; row < end; ++row) {
            Changes& sum = rows[static_cast<std::size_t>(row)];
            for (int column = 0; column < now.width(); ++column) {
                glm::vec3& last = change.at(column, row);
                const glm::vec3 is = now.at(column, row) - then.at(column, row);
                sum.product += static_cast<double>(glm::dot(is, last));
                sum.square += static_cast<double>(glm::dot(last, last));
                last = is;
            }
        }
    });
    Changes all;
    for (const Changes& one : rows) {
        all.product += one.product;
        all.square += one.square;
    }
    return all;
}

}  // namespace

Image afterSteps(int steps, Image picture, const Missing& missing, const Progress& progress) {
    Image before = picture, change(picture.width(), picture.height());
    float momentum = 0.0f;
    const auto part = [&](int number) {
        return static_cast<float>(number) / static_cast<float>(steps);
    };
    for (int number = 0; number < steps; ++number) {
        // From where the last two steps point to, in place of the one before.
        Image& start = before;
        forPixels(picture, [&](std::size_t i) {
            const glm::vec3 now = picture.pixels()[i];
            start.pixels()[i] = mended(now, momentum * (now - start.pixels()[i]));
        });
        Image next = missing(start, partOf(progress, part(number), part(number + 1)));
        if (next.empty()) break;
        forPixels(picture, [&](std::size_t i) {
            next.pixels()[i] = mended(start.pixels()[i], next.pixels()[i]);
        });
        momentum = compare(next, start, change).momentum();
        before = std::exchange(picture, std::move(next));
    }
    return picture;
}

}  // namespace tukor
