#include "tukor/environment/repair.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "tukor/base/error.h"

namespace tukor {

namespace {

/// Radiance with which one can calculate: sums of more overflow, and no light is as bright.
constexpr float kMost = 1e30f;

/// False for no number, too.
bool usable(float value) {
    return std::abs(value) <= kMost;
}

bool usable(glm::vec3 pixel) {
    return usable(pixel.x) && usable(pixel.y) && usable(pixel.z);
}

bool sound(glm::vec3 pixel) {
    return usable(pixel) && pixel.x >= 0.0f && pixel.y >= 0.0f && pixel.z >= 0.0f;
}

/// The replacement of a component that is not finite, from the pixels around it as they were.
float fromNeighbours(const Image& image, int column, int row, int component) {
    float sum = 0.0f, most = 0.0f;
    int count = 0;
    for (int j = std::max(row - 1, 0); j <= std::min(row + 1, image.height() - 1); ++j)
        for (int i = column - 1; i <= column + 1; ++i) {
            const float value = image.at((i + image.width()) % image.width(), j)[component];
            if (!usable(value)) continue;
            sum += std::max(value, 0.0f);
            most = std::max(most, value);
            ++count;
        }
    const float original = image.at(column, row)[component];
    if (original > 0.0f) return most;
    return count > 0 && std::isnan(original) ? sum / static_cast<float>(count) : 0.0f;
}

}  // namespace

RepairCount repairRadiance(Image& image) {
    struct Repair {
        int column, row;
        glm::vec3 pixel;
    };
    // Collected first: a replaced pixel must not become the neighbour that the next one copies.
    std::vector<Repair> repairs;
    RepairCount count;
    for (int row = 0; row < image.height(); ++row)
        for (int column = 0; column < image.width(); ++column) {
            const glm::vec3 pixel = image.at(column, row);
            if (sound(pixel)) continue;
            glm::vec3 repaired = pixel;
            bool finite = true, positive = true;
            for (int i = 0; i < 3; ++i) {
                if (!usable(pixel[i])) {
                    repaired[i] = fromNeighbours(image, column, row, i);
                    finite = false;
                } else if (pixel[i] < 0.0f) {
                    repaired[i] = 0.0f;
                    positive = false;
                }
            }
            count.notFinite += finite ? 0 : 1;
            count.negative += positive ? 0 : 1;
            repairs.push_back({column, row, repaired});
        }
    for (const Repair& repair : repairs) image.at(repair.column, repair.row) = repair.pixel;
    return count;
}

std::vector<std::string> describeRepairs(const RepairCount& count) {
    std::vector<std::string> sentences;
    const auto pixels = [](int number) {
        return number == 1 ? std::string("1 pixel") : fmt::format("{} pixels", number);
    };
    if (count.notFinite > 0)
        sentences.push_back(
            fmt::format("{} not finite, replaced by the neighbours", pixels(count.notFinite)));
    if (count.negative > 0)
        sentences.push_back(
            fmt::format("{} with negative radiance, set to 0", pixels(count.negative)));
    return sentences;
}

std::vector<std::string> repairPictures(std::string_view name, std::span<Image> pictures) {
    RepairCount repairs;
    for (Image& picture : pictures) {
        const std::span<const glm::vec3> pixels = picture.pixels();
        const auto broken = static_cast<std::size_t>(std::count_if(
            pixels.begin(), pixels.end(), [](const glm::vec3& pixel) { return !usable(pixel); }));
        if (broken > pixels.size() / 2)
            throw Error(fmt::format("{}: {} of {} pixels are not finite; the file is damaged", name,
                                    broken, pixels.size()));
        const RepairCount count = repairRadiance(picture);
        repairs.notFinite += count.notFinite;
        repairs.negative += count.negative;
    }
    return describeRepairs(repairs);
}

}  // namespace tukor
