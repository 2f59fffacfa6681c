#include "tukor/environment/cube_axes.h"

#include "tukor/base/parallel.h"

namespace tukor {

namespace {

int dot(glm::ivec3 a, glm::ivec3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// Calls move(texel as stored, texel in the world's cube) for two faces' texels that look the same
/// way, for every pair of them.
template <class Move>
void forEachPair(int faceSize, const CubeAxes& axes, const Move& move) {
    const CubeAxes world = worldCubeAxes();
    parallelFor(0, 6 * faceSize, 64, [&](int begin, int end) {
        for (int line = begin; line < end; ++line) {
            const auto face = static_cast<std::size_t>(line / faceSize);
            const FaceAxes& stored = axes[face];
            std::size_t seen = 0;
            while (dot(world[seen].out, stored.out) != 1) ++seen;
            const FaceAxes& own = world[seen];
            // In half texels from the middle of the face.
            const int t = 2 * (line % faceSize) + 1 - faceSize;
            for (int column = 0; column < faceSize; ++column) {
                const glm::ivec3 place = (2 * column + 1 - faceSize) * stored.s + t * stored.t;
                const auto at = [&](int row, int c) {
                    return static_cast<std::size_t>(row) * static_cast<std::size_t>(faceSize) +
                           static_cast<std::size_t>(c);
                };
                move(face, at(line % faceSize, column), seen,
                     at((dot(place, own.t) + faceSize - 1) / 2,
                        (dot(place, own.s) + faceSize - 1) / 2));
            }
        }
    });
}

}  // namespace

CubeAxes worldCubeAxes() noexcept {
    CubeAxes axes;
    for (const CubeFace face : kCubeFaces) {
        const glm::vec3 out = directionFromCube({face, 0.0f, 0.0f});
        axes[static_cast<std::size_t>(face)] = {
            glm::ivec3(directionFromCube({face, 1.0f, 0.0f}) - out),
            glm::ivec3(directionFromCube({face, 0.0f, 1.0f}) - out), glm::ivec3(out)};
    }
    return axes;
}

CubeMap storedCube(const CubeMap& world, const CubeAxes& axes) {
    CubeMap stored(world.faceSize());
    forEachPair(world.faceSize(), axes,
                [&](std::size_t face, std::size_t i, std::size_t seen, std::size_t j) {
                    stored.texels(kCubeFaces[face])[i] = world.texels(kCubeFaces[seen])[j];
                });
    return stored;
}

CubeMap worldCube(const CubeMap& stored, const CubeAxes& axes) {
    CubeMap world(stored.faceSize());
    forEachPair(stored.faceSize(), axes,
                [&](std::size_t face, std::size_t i, std::size_t seen, std::size_t j) {
                    world.texels(kCubeFaces[seen])[j] = stored.texels(kCubeFaces[face])[i];
                });
    return world;
}

}  // namespace tukor
