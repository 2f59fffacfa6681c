#include "tukor/trace/texture_lookup.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "tukor/base/parallel.h"
#include "tukor/image/display.h"

namespace tukor::trace {

namespace {

const std::array<float, 256>& linearCodes() noexcept {
    static const std::array<float, 256> codes = [] {
        std::array<float, 256> values{};
        for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(i) / 255.0f;
        return values;
    }();
    return codes;
}

int wrapped(int i, int size, Wrap wrap) noexcept {
    if (wrap == Wrap::clamp) return std::clamp(i, 0, size - 1);
    const int period = wrap == Wrap::mirror ? 2 * size : size;
    i %= period;
    if (i < 0) i += period;
    return i < size ? i : period - 1 - i;
}

}  // namespace

TexturePyramid::TexturePyramid(std::shared_ptr<const Texels> texels, Encoding encoding)
    : texels_(std::move(texels)),
      linear_(encoding == Encoding::srgb ? linearFromSrgb8().data() : linearCodes().data()),
      channels_(texels_->channels) {
    levels_.push_back({texels_->width, texels_->height, texels_->bytes.data()});
    while (levels_.back().width > 1 || levels_.back().height > 1) addLevel();
}

void TexturePyramid::addLevel() {
    const Level from = levels_.back();
    const int width = std::max(from.width / 2, 1), height = std::max(from.height / 2, 1);
    const auto n = static_cast<std::size_t>(channels_);
    std::vector<std::uint8_t> texels(static_cast<std::size_t>(width) *
                                     static_cast<std::size_t>(height) * n);
    const bool srgb = linear_ == linearFromSrgb8().data();
    parallelFor(0, height, 64, [&](int begin, int end) {
        for (int row = begin; row < end; ++row)
            for (int column = 0; column < width; ++column) {
                glm::vec4 sum(0.0f);
                for (const int down : {0, 1})
                    for (const int right : {0, 1})
                        sum += texel(from, std::min(2 * column + right, from.width - 1),
                                     std::min(2 * row + down, from.height - 1));
                sum *= 0.25f;
                std::uint8_t* const to =
                    &texels[(static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                             static_cast<std::size_t>(column)) *
                            n];
                for (int c = 0; c < channels_; ++c)
                    to[c] = srgb && c < 3 ? srgb8(sum[c])
                                          : static_cast<std::uint8_t>(sum[c] * 255.0f + 0.5f);
            }
    });
    made_.push_back(std::move(texels));
    levels_.push_back({width, height, made_.back().data()});
}

glm::vec4 TexturePyramid::texel(const Level& level, int column, int row) const noexcept {
    const std::uint8_t* const t =
        level.texels + (static_cast<std::size_t>(row) * static_cast<std::size_t>(level.width) +
                        static_cast<std::size_t>(column)) *
                           static_cast<std::size_t>(channels_);
    return {linear_[t[0]], linear_[t[1]], linear_[t[2]],
            channels_ == 4 ? static_cast<float>(t[3]) / 255.0f : 1.0f};
}

glm::vec4 TexturePyramid::bilinear(const Level& level, glm::vec2 place,
                                   const TextureMap& map) const noexcept {
    const float x = place.x * static_cast<float>(level.width) - 0.5f;
    const float y = place.y * static_cast<float>(level.height) - 0.5f;
    const float left = std::floor(x), top = std::floor(y);
    const auto column = [&](float c) {
        return wrapped(static_cast<int>(c), level.width, map.wrapU);
    };
    const auto row = [&](float r) { return wrapped(static_cast<int>(r), level.height, map.wrapV); };
    if (!map.smooth) return texel(level, column(std::round(x)), row(std::round(y)));
    const int c0 = column(left), c1 = column(left + 1.0f), r0 = row(top), r1 = row(top + 1.0f);
    return glm::mix(glm::mix(texel(level, c0, r0), texel(level, c1, r0), x - left),
                    glm::mix(texel(level, c0, r1), texel(level, c1, r1), x - left), y - top);
}

glm::vec4 TexturePyramid::at(glm::vec2 uv, float width, const TextureMap& map) const noexcept {
    glm::vec2 place = map.imageFromUv * glm::vec3(uv, 1.0f);
    // Beyond a million repetitions floats have no texels left; false for NaN.
    if (!(glm::abs(place.x) < 1e6f && glm::abs(place.y) < 1e6f)) place = glm::vec2(0.0f);
    if (map.wrapU != Wrap::clamp) place.x -= 2.0f * std::floor(0.5f * place.x);
    if (map.wrapV != Wrap::clamp) place.y -= 2.0f * std::floor(0.5f * place.y);
    place = glm::clamp(place, glm::vec2(-8.0f), glm::vec2(8.0f));
    const float texels = width * static_cast<float>(std::max(texels_->width, texels_->height));
    const auto last = static_cast<float>(levels_.size() - 1);
    const float level = texels > 1.0f ? std::min(std::log2(texels), last) : 0.0f;
    const auto finer = static_cast<std::size_t>(level);
    const float between = level - static_cast<float>(finer);
    const glm::vec4 a = bilinear(levels_[finer], place, map);
    if (!(between > 0.0f) || finer + 1 == levels_.size()) return a;
    return glm::mix(a, bilinear(levels_[finer + 1], place, map), between);
}

const TexturePyramid* TextureStore::pyramidOf(const TextureMap& map, TextureRole role) {
    if (map.texels == nullptr || map.texels->width < 1) return nullptr;
    std::unique_ptr<TexturePyramid>& pyramid = pyramids_[{map.texels.get(), isSrgb(role)}];
    if (!pyramid)
        pyramid = std::make_unique<TexturePyramid>(
            map.texels,
            isSrgb(role) ? TexturePyramid::Encoding::srgb : TexturePyramid::Encoding::linear);
    return pyramid.get();
}

}  // namespace tukor::trace
