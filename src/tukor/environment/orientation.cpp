#include "tukor/environment/orientation.h"

#include <numbers>

namespace tukor {

namespace {

/// As the pictures in ImfEnvmap.h: +t is down, and +s lies to the right of one who looks along
/// `out`.
CubeAxes uprightAxes() {
    constexpr glm::ivec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
    return {{{z, -y, x}, {-z, -y, -x}, {x, -z, y}, {x, z, -y}, {-x, -y, z}, {x, -y, -z}}};
}

}  // namespace

double turnFrom(Orientation orientation) noexcept {
    switch (orientation) {
        case Orientation::blender:           // Cycles, equirectangular_to_direction
        case Orientation::three:             // equirectUv in common.glsl
            return -0.5 * std::numbers::pi;  // the middle, at -Z here, goes to +X
        case Orientation::openexr:           // ImfEnvmap.h, LatLongMap
        case Orientation::filament:          // cmgen, mirrored as it does by default
            return std::numbers::pi;
        case Orientation::unreal:  // LookupLongLat in its texture compressor: -Y, which is -Z here
        case Orientation::opengl:
            break;
    }
    return 0.0;
}

CubeAxes cubeAxesOf(Orientation orientation) noexcept {
    switch (orientation) {
        case Orientation::three:  // the matrix _m of its WebGLMaterials
            return mapped(worldCubeAxes(), [](glm::ivec3 a) { return glm::ivec3(-a.x, a.y, a.z); });
        case Orientation::unreal:  // as its glTF importer exchanges Y and Z
            return mapped(worldCubeAxes(), [](glm::ivec3 a) { return glm::ivec3(a.x, a.z, a.y); });
        case Orientation::openexr:
            return uprightAxes();
        default:
            return worldCubeAxes();
    }
}

}  // namespace tukor
