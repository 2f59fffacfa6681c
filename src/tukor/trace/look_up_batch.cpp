// Look-ups in an EnvironmentMap, many together. Loops over arrays of constant length without
// branches: the compiler does eight of their turns at once.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "tukor/trace/environment_map.h"
#include "tukor/transport/footprint.h"
#include "tukor/transport/look_ups.h"

namespace tukor::trace {

namespace {

using Texel = LookUpBatch::Texel;
constexpr int kRoom = LookUpBatch::kRoom;
constexpr float kPi = std::numbers::pi_v<float>;

template <typename Number>
struct alignas(64) Lanes {
    std::array<Number, kRoom> at;
    Number& operator[](int i) noexcept { return at[static_cast<std::size_t>(i)]; }
    Number operator[](int i) const noexcept { return at[static_cast<std::size_t>(i)]; }
};

/// Where directions meet the panels: 0 at the left and upper edge, 1 at the right and lower one.
struct Places {
    Lanes<float> x, y;
    Lanes<int> panel;
};

/// The upper left of the four texels around a place, and how far the place lies beyond it.
struct Corners {
    Lanes<int> line, column;
    Lanes<float> right, down;
};

/// atan2 to 2e-7: minimax on [0, 1] and reflections.
inline float quickAtan2(float y, float x) {
    const float ax = std::abs(x), ay = std::abs(y);
    const float most = std::max(ax, ay), least = std::min(ax, ay);
    const float t = least / std::max(most, 1e-37f);
    const float s = t * t;
    float a = 0.00282363896258175373f;
    a = a * s - 0.0159569028764963150f;
    a = a * s + 0.0425049886107444763f;
    a = a * s - 0.0748900920152664185f;
    a = a * s + 0.106347933411598206f;
    a = a * s - 0.142027363181114197f;
    a = a * s + 0.199926957488059998f;
    a = a * s - 0.333331018686294556f;
    a = a * s * t + t;
    a = ay > ax ? 0.5f * kPi - a : a;
    a = x < 0.0f ? kPi - a : a;
    return y < 0.0f ? -a : a;
}

void placeOnPanorama(const LookUpBatch& batch, int count, Places& places) {
    const float *x = batch.x.data(), *y = batch.y.data(), *z = batch.z.data();
    for (int i = 0; i < count; ++i) {
        const float across = std::sqrt(x[i] * x[i] + z[i] * z[i]);
        places.x[i] = 0.5f + quickAtan2(x[i], -z[i]) * (0.5f / kPi);
        places.y[i] = quickAtan2(across, y[i]) * (1.0f / kPi);
        places.panel[i] = 0;
    }
}

/// As cubeFromDirection, by selections.
void placeOnCube(const LookUpBatch& batch, int count, Places& places) {
    for (int i = 0; i < count; ++i) {
        const auto n = static_cast<std::size_t>(i);
        const float x = batch.x[n], y = batch.y[n], z = batch.z[n];
        const float ax = std::abs(x), ay = std::abs(y), az = std::abs(z);
        const bool alongX = (ax >= ay) & (ax >= az);
        const bool alongY = ay >= az;
        const float sx = x > 0.0f ? -z : z;
        const float ty = y > 0.0f ? z : -z;
        const float sz = z > 0.0f ? x : -x;
        const float scale = 0.5f / (alongX ? ax : alongY ? ay : az);
        places.x[i] = 0.5f + scale * (alongX ? sx : alongY ? x : sz);
        places.y[i] = 0.5f + scale * (alongX ? -y : alongY ? ty : -y);
        const int negative = (alongX ? x : alongY ? y : z) > 0.0f ? 0 : 1;
        places.panel[i] = negative + (alongX ? 0 : alongY ? 2 : 4);
    }
}

/// Sizes by level.
struct LevelTable {
    std::array<float, 8> width{}, height{};
    std::array<int, 8> rows{};
};

void cornersOf(const Places& places, const Lanes<int>& level, const LevelTable& table, int count,
               Corners& corners) {
    Lanes<float> width, height;
    Lanes<int> rows;
    for (int i = 0; i < count; ++i) {  // by itself: what is looked up in a table is no vector
        const auto l = static_cast<std::size_t>(level[i]);
        width[i] = table.width[l];
        height[i] = table.height[l];
        rows[i] = table.rows[l];
    }
    for (int i = 0; i < count; ++i) {
        const float w = width[i], h = height[i];
        // Borders shift all texels by one. Clamped so that not even a NaN reads out of bounds.
        const float u = std::min(std::max(0.0f, places.x[i] * w + 0.5f), w + 0.5f);
        const float v = std::min(std::max(0.0f, places.y[i] * h + 0.5f), h + 0.5f);
        const float column = std::min(std::floor(u), w), row = std::min(std::floor(v), h);
        corners.right[i] = u - column;
        corners.down[i] = v - row;
        corners.line[i] = places.panel[i] * rows[i] + static_cast<int>(row);
        corners.column[i] = static_cast<int>(column);
    }
}

inline Texel between(const Texel& a, const Texel& b, float t) {
    return {a.r + t * (b.r - a.r), a.g + t * (b.g - a.g), a.b + t * (b.b - a.b),
            a.unused + t * (b.unused - a.unused)};
}

}  // namespace

glm::vec3 LookUpBatch::sum(int first, int number) const noexcept {
    Texel all = found[static_cast<std::size_t>(first)];
    for (int i = 1; i < number; ++i) {
        const Texel& one = found[static_cast<std::size_t>(first + i)];
        all = {all.r + one.r, all.g + one.g, all.b + one.b, all.unused + one.unused};
    }
    return {all.r, all.g, all.b};
}

int EnvironmentMap::add(LookUpBatch& batch, glm::vec3 direction, float solidAngle) const noexcept {
    const auto i = static_cast<std::size_t>(batch.count++);
    const glm::vec3 d = turned(direction);
    batch.x[i] = d.x;
    batch.y[i] = d.y;
    batch.z[i] = d.z;
    batch.level[i] = transport::footprintLevel(solidAngle, equivalentFaceSize_);
    return 1;
}

int EnvironmentMap::add(LookUpBatch& batch, glm::vec3 direction, glm::vec3 dx, glm::vec3 dy,
                        int mostLookUps) const noexcept {
    const float texelsPerRadian =
        transport::kTexelsPerRadian * static_cast<float>(equivalentFaceSize_);
    const transport::LookUps l = transport::lookUpsOver(dx, dy, texelsPerRadian, mostLookUps);
    const glm::vec3 first = turned(direction + l.first);
    if (l.across * l.down == 1) {  // most are
        const auto n = static_cast<std::size_t>(batch.count++);
        batch.x[n] = first.x;
        batch.y[n] = first.y;
        batch.z[n] = first.z;
        batch.level[n] = l.level;
        return 1;
    }
    const glm::vec3 stepX = turned(l.stepX), stepY = turned(l.stepY);
    for (int j = 0; j < l.down; ++j) {
        glm::vec3 at = first + static_cast<float>(j) * stepY;
        for (int i = 0; i < l.across; ++i, at += stepX) {
            const auto n = static_cast<std::size_t>(batch.count++);
            batch.x[n] = at.x;
            batch.y[n] = at.y;
            batch.z[n] = at.z;
            batch.level[n] = l.level;
        }
    }
    return l.across * l.down;
}

void EnvironmentMap::look(LookUpBatch& batch) const noexcept {
    if (batch.count == 0) return;
    const int count = (batch.count + 7) & ~7;
    for (int i = batch.count; i < count; ++i) {
        const auto n = static_cast<std::size_t>(i);
        batch.x[n] = batch.y[n] = batch.z[n] = batch.level[n] = 0.0f;
    }
    LevelTable table;
    for (std::size_t l = 0; l < levels_.size(); ++l) {
        table.width[l] = static_cast<float>(levels_[l].width);
        table.height[l] = static_cast<float>(levels_[l].height);
        table.rows[l] = levels_[l].height + 2;
    }
    Places places;
    form_ == Form::cube ? placeOnCube(batch, count, places) : placeOnPanorama(batch, count, places);
    const auto coarsest = static_cast<float>(levels_.size() - 1);
    Lanes<int> finer, coarser;
    Lanes<float> share;  // of the coarser
    for (int i = 0; i < count; ++i) {
        const float level =
            std::min(std::max(0.0f, batch.level[static_cast<std::size_t>(i)]), coarsest);
        const float finest = std::floor(level);
        finer[i] = static_cast<int>(finest);
        coarser[i] = static_cast<int>(std::min(finest + 1.0f, coarsest));
        share[i] = level - finest;
    }
    Corners a, b;
    cornersOf(places, finer, table, count, a);
    cornersOf(places, coarser, table, count, b);
    // The upper of two lines of texels, and how far the lower is from it.
    const auto above = [&](const Level& level, const Corners& corners, int i) {
        const std::size_t stride = static_cast<std::size_t>(level.width) + 2;
        return level.texels.get() + static_cast<std::size_t>(corners.line[i]) * stride +
               static_cast<std::size_t>(corners.column[i]);
    };
    const auto levelOf = [&](const Lanes<int>& level, int i) -> const Level& {
        return levels_[static_cast<std::size_t>(level[i])];
    };
    for (int i = 0; i < batch.count; ++i) {
        const Level& level = levelOf(finer, i);
        const Texel* texel = above(level, a, i);
        __builtin_prefetch(texel);
        __builtin_prefetch(texel + level.width + 2);
    }
    const auto bilinear = [&](const Level& level, const Corners& corners, int i) {
        const Texel* upper = above(level, corners, i);
        const Texel* lower = upper + level.width + 2;
        const float right = corners.right[i];
        return between(between(upper[0], upper[1], right), between(lower[0], lower[1], right),
                       corners.down[i]);
    };
    for (int i = 0; i < batch.count; ++i) {
        Texel found = bilinear(levelOf(finer, i), a, i);
        if (share[i] > 0.0f) found = between(found, bilinear(levelOf(coarser, i), b, i), share[i]);
        batch.found[static_cast<std::size_t>(i)] = found;
    }
}

glm::vec3 EnvironmentMap::radiance(glm::vec3 direction, float solidAngle) const noexcept {
    LookUpBatch batch;
    add(batch, direction, solidAngle);
    look(batch);
    return batch.sum(0, 1);
}

glm::vec3 EnvironmentMap::radiance(glm::vec3 direction, glm::vec3 dx, glm::vec3 dy,
                                   int mostLookUps) const noexcept {
    LookUpBatch batch;
    const int number = add(batch, direction, dx, dy, mostLookUps);
    look(batch);
    return batch.sum(0, number) / static_cast<float>(number);
}

}  // namespace tukor::trace
