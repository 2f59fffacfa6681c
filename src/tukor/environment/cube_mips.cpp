#include "tukor/environment/cube_mips.h"

#include <algorithm>

#include "tukor/base/error.h"
#include "tukor/base/parallel.h"
#include "tukor/environment/cube_texel.h"

namespace tukor {

namespace {

/// The source texels along one axis that a target texel covers, and how much of each end it covers.
struct Cover {
    int first;
    int last;
    float firstPart;
    float lastPart;

    [[nodiscard]] float part(int i) const {
        return i == first ? firstPart : i == last ? lastPart : 1.0f;
    }
};

std::vector<Cover> covers(int sourceSize, int targetSize) {
    std::vector<Cover> result(static_cast<std::size_t>(targetSize));
    for (int i = 0; i < targetSize; ++i) {
        // Numerators over targetSize: exact in integers.
        const long long begin = static_cast<long long>(i) * sourceSize;
        const long long end = begin + sourceSize;
        Cover& cover = result[static_cast<std::size_t>(i)];
        cover.first = static_cast<int>(begin / targetSize);
        cover.last = static_cast<int>((end - 1) / targetSize);
        const auto part = [&](int texel) {
            const long long from = std::max(begin, static_cast<long long>(texel) * targetSize);
            const long long to = std::min(end, static_cast<long long>(texel + 1) * targetSize);
            return static_cast<float>(to - from) / static_cast<float>(targetSize);
        };
        cover.firstPart = part(cover.first);
        cover.lastPart = part(cover.last);
    }
    return result;
}

CubeMap constantCube(const glm::vec3& value, int faceSize) {
    CubeMap cube(faceSize);
    for (const CubeFace face : kCubeFaces)
        std::fill(cube.texels(face).begin(), cube.texels(face).end(), value);
    return cube;
}

}  // namespace

bool isConstant(const CubeMap& cube) noexcept {
    const glm::vec3& first = cube.texels(CubeFace::posX).front();
    return std::all_of(kCubeFaces.begin(), kCubeFaces.end(), [&](CubeFace face) {
        const std::span<const glm::vec3> texels = cube.texels(face);
        return std::all_of(texels.begin(), texels.end(),
                           [&](const glm::vec3& texel) { return texel == first; });
    });
}

CubeMap shrunkCube(const CubeMap& cube, int faceSize) {
    TUKOR_ASSERT(faceSize >= 1 && faceSize <= cube.faceSize());
    if (isConstant(cube)) return constantCube(cube.texels(CubeFace::posX).front(), faceSize);
    const std::vector<Cover> cover = covers(cube.faceSize(), faceSize);
    const std::vector<float> angles = faceSolidAngles(cube.faceSize());
    CubeMap result(faceSize);
    parallelFor(0, 6 * faceSize, std::max(1, faceSize / 8), [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
            const auto face = static_cast<CubeFace>(i / faceSize);
            const Cover& rows = cover[static_cast<std::size_t>(i % faceSize)];
            const std::span<const glm::vec3> source = cube.texels(face);
            glm::vec3* target = &result.texels(
                face)[static_cast<std::size_t>(i % faceSize) * static_cast<std::size_t>(faceSize)];
            for (const Cover& columns : cover) {
                glm::vec3 sum(0.0f);
                float weights = 0.0f;
                for (int row = rows.first; row <= rows.last; ++row) {
                    const std::size_t line =
                        static_cast<std::size_t>(row) * static_cast<std::size_t>(cube.faceSize());
                    for (int column = columns.first; column <= columns.last; ++column) {
                        const std::size_t at = line + static_cast<std::size_t>(column);
                        const float weight = angles[at] * rows.part(row) * columns.part(column);
                        sum += weight * source[at];
                        weights += weight;
                    }
                }
                *target++ = sum / weights;
            }
        }
    });
    return result;
}

CubeMap resizedCube(const CubeMap& cube, int faceSize) {
    if (faceSize <= cube.faceSize()) return shrunkCube(cube, faceSize);
    if (isConstant(cube)) return constantCube(cube.texels(CubeFace::posX).front(), faceSize);
    CubeMap result(faceSize);
    parallelFor(0, 6 * faceSize, 16, [&](int begin, int end) {
        for (int line = begin; line < end; ++line) {
            const auto face = static_cast<CubeFace>(line / faceSize);
            const int row = line % faceSize;
            for (int column = 0; column < faceSize; ++column)
                result.texels(
                    face)[static_cast<std::size_t>(row) * static_cast<std::size_t>(faceSize) +
                          static_cast<std::size_t>(column)] =
                    cube.radiance(directionFromTexel({face, column, row}, faceSize));
        }
    });
    return result;
}

std::vector<CubeMap> cubeMips(const CubeMap& cube) {
    std::vector<CubeMap> mips;
    for (int size = cube.faceSize() / 2; size >= 1; size /= 2)
        mips.push_back(shrunkCube(mips.empty() ? cube : mips.back(), size));
    return mips;
}

}  // namespace tukor
