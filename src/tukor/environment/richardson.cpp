#include "tukor/environment/richardson.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "tukor/base/parallel.h"

namespace tukor {

namespace {

constexpr float kMostMomentum = 0.95f;
// No pixel falls below this part of itself at once: from 0 it would never rise again.
constexpr float kLeastPart = 0.25f;

/// What the last two steps changed, relative to what they changed: their product and the square of
/// the earlier, over all pixels.
struct Changes {
    double product = 0.0;
    double square = 0.0;
};

/// Puts image + momentum * (image - before) in place of `before`.
void predict(Image& before, const Image& image, float momentum) {
    parallelFor(0, image.height(), 16, [&](int begin, int end) {
        for (int row = begin; row < end; ++row)
            for (int column = 0; column < image.width(); ++column) {
                const glm::vec3 now = image.at(column, row);
                glm::vec3& then = before.at(column, row);
                then = glm::max(now + momentum * (now - then), kLeastPart * now);
            }
    });
}

/// Puts to - from in place of `last`.
Changes compare(const Image& from, const Image& to, Image& last) {
    std::vector<Changes> rows(static_cast<std::size_t>(from.height()));
    parallelFor(0, from.height(), 16, [&](int begin, int end) {
        for (int row = begin; row < end; ++row) {
            Changes& sum = rows[static_cast<std::size_t>(row)];
            for (int column = 0; column < from.width(); ++column) {
                const glm::vec3 start = from.at(column, row);
                const glm::vec3 change = to.at(column, row) - start;
                glm::vec3& before = last.at(column, row);
                const glm::vec3 scaled = before / (start + 1e-6f);
                sum.product += static_cast<double>(glm::dot(change, scaled));
                sum.square += static_cast<double>(glm::dot(before, scaled));
                before = change;
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

Image afterSteps(int steps, Image image, const RichardsonStep& step) {
    Image before = image, last(image.width(), image.height());
    float momentum = 0.0f;
    const auto part = [&](int number) {
        return static_cast<float>(number) / static_cast<float>(steps);
    };
    for (int number = 0; number < steps; ++number) {
        predict(before, image, momentum);
        Image next = before;
        if (!step(next, part(number), part(number + 1))) break;
        const Changes changes = compare(before, next, last);
        momentum = changes.square > 0.0
                       ? static_cast<float>(std::clamp(changes.product / changes.square, 0.0,
                                                       static_cast<double>(kMostMomentum)))
                       : 0.0f;
        before = std::exchange(image, std::move(next));
    }
    return image;
}

}  // namespace tukor
