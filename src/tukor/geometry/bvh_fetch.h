// How the traversal reads a Bvh: from arrays in C++, from three textures in GLSL. The two hosts of
// bvh_traversal.h differ here and nowhere else.
//
// A texture holds 1024 texels a row. bvhNodes is RGBA32UI, the others are RGBA32F.
#pragma once
#include "tukor/optics/shared.h"

#ifdef __cplusplus
namespace tukor::geometry {

/// Texels of a Bvh. Whoever owns them outlives the view.
struct BvhView {
    const glm::uvec4* nodes;
    const glm::vec4* triangles;
    const glm::vec4* normals;
};

[[nodiscard]] inline glm::uvec4 bvhNodeTexel(const BvhView& bvh, int index) {
    return bvh.nodes[index];
}
[[nodiscard]] inline glm::vec4 bvhTriangleTexel(const BvhView& bvh, int index) {
    return bvh.triangles[index];
}
[[nodiscard]] inline glm::vec4 bvhNormalTexel(const BvhView& bvh, int index) {
    return bvh.normals[index];
}

}  // namespace tukor::geometry
/// First parameter of functions that read the Bvh, and the argument for it; GLSL has one Bvh,
/// global.
#define TUKOR_BVH_PARAMETER const BvhView &bvh,
#define TUKOR_BVH_ARGUMENT bvh,
#else
uniform highp usampler2D bvhNodes;
uniform highp sampler2D bvhTriangles;
uniform highp sampler2D bvhNormals;

ivec2 bvhTexel(int index) {
    return ivec2(index & 1023, index >> 10);
}
uvec4 bvhNodeTexel(int index) {
    return texelFetch(bvhNodes, bvhTexel(index), 0);
}
vec4 bvhTriangleTexel(int index) {
    return texelFetch(bvhTriangles, bvhTexel(index), 0);
}
vec4 bvhNormalTexel(int index) {
    return texelFetch(bvhNormals, bvhTexel(index), 0);
}
#define TUKOR_BVH_PARAMETER
#define TUKOR_BVH_ARGUMENT
#endif
