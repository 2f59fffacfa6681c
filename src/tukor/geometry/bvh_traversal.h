// The nearest triangle along a ray: traversal of a four-wide tree of quantised boxes. Shared
// source.
//
// A node is three texels of unsigned integers, for children 0 to 3:
//
//             x                y                z                w
//     0   origin.x         origin.y         origin.z      (floats)   exponents of the scale, bytes
//     x y z 1   least x, 4 bytes least y          least z                  first child | low kinds
//     << 24 2   most x, 4 bytes  most y           most z                   first triangle | high
//     kinds << 24
//
// Box planes lie at origin + byte * scale and enclose what is in them. A kind has four bits, child
// 0 in the lowest of the low byte, child 2 in the lowest of the high byte: 0 no child, 15 an inner
// node, else the number of triangles of a leaf. Inner children follow each other from the first
// child, triangles of leaves from the first triangle.
//
// Triangle t has texels 3t to 3t + 2 in both arrays: its corners, with the rank of the triangle in
// the source's order in the first w; and the corners' normals, with its part in the first w.
#pragma once
#include "tukor/geometry/bvh_fetch.h"

TUKOR_SHARED_BEGIN(geometry)

/// No ray needs more; buildBvh keeps that promise.
TUKOR_CONST int kBvhStackSize = 32;
TUKOR_CONST uint kBvhInner = 15u;

struct BvhHit {
    float t;       // in units of the ray's direction
    float u;       // weights of the second and third corner: the place is
    float v;       // v0 + u e1 + v e2, far better conditioned than origin + t * direction
    int triangle;  // in the order of the Bvh; -1: none
    float rank;    // of the triangle in the source's order: of equally near ones the first wins
};

TUKOR_FN BvhHit noBvhHit(float reach) {
    BvhHit hit;
    hit.t = reach;
    hit.u = 0.0f;
    hit.v = 0.0f;
    hit.triangle = -1;
    hit.rank = -1.0f;
    return hit;
}

/// A ray, and the rows of the map that shears its direction onto the z axis with length 1.
struct BvhRay {
    vec3 origin;
    vec3 x;
    vec3 y;
    vec3 z;
};

TUKOR_FN BvhRay bvhRay(vec3 origin, vec3 direction) {
    BvhRay ray;
    ray.origin = origin;
    vec3 size = abs(direction);
    if (size.x > size.y && size.x > size.z) {
        ray.x = vec3(-direction.y / direction.x, 1.0f, 0.0f);
        ray.y = vec3(-direction.z / direction.x, 0.0f, 1.0f);
        ray.z = vec3(1.0f / direction.x, 0.0f, 0.0f);
    } else if (size.y > size.z) {
        ray.x = vec3(0.0f, -direction.z / direction.y, 1.0f);
        ray.y = vec3(1.0f, -direction.x / direction.y, 0.0f);
        ray.z = vec3(0.0f, 1.0f / direction.y, 0.0f);
    } else {
        ray.x = vec3(1.0f, 0.0f, -direction.x / direction.z);
        ray.y = vec3(0.0f, 1.0f, -direction.y / direction.z);
        ray.z = vec3(0.0f, 0.0f, 1.0f / direction.z);
    }
    return ray;
}

/// On which side of the edge from p to q the z axis passes: never the wrong one, at most 0, because
/// each product is rounded by itself. Fused into one multiply-add, neighbours could disagree, and
/// the ray would slip between them; max() keeps compilers from that.
TUKOR_FN float bvhEdge(vec3 p, vec3 q) {
    return max(p.x * q.y, -3e38f) - max(p.y * q.x, -3e38f);
}

/// Makes `triangle` the hit if the ray meets it at t > `beyond` before. [Woop, Benthin and Wald
/// 2013]
TUKOR_PROCEDURE bvhTriangle(TUKOR_BVH_PARAMETER int triangle, BvhRay ray, float beyond,
                            TUKOR_INOUT(BvhHit) hit) {
    vec4 first = bvhTriangleTexel(TUKOR_BVH_ARGUMENT 3 * triangle);
    vec3 a = vec3(first) - ray.origin;
    vec3 b = vec3(bvhTriangleTexel(TUKOR_BVH_ARGUMENT 3 * triangle + 1)) - ray.origin;
    vec3 c = vec3(bvhTriangleTexel(TUKOR_BVH_ARGUMENT 3 * triangle + 2)) - ray.origin;
    a = vec3(dot(ray.x, a), dot(ray.y, a), dot(ray.z, a));
    b = vec3(dot(ray.x, b), dot(ray.y, b), dot(ray.z, b));
    c = vec3(dot(ray.x, c), dot(ray.y, c), dot(ray.z, c));
    float wa = bvhEdge(b, c);
    float wb = bvhEdge(c, a);
    float wc = bvhEdge(a, b);
    if (min(wa, min(wb, wc)) < 0.0f && max(wa, max(wb, wc)) > 0.0f) return;
    float sum = wa + wb + wc;
    if (sum == 0.0f) return;
    if (wa * wb * wc == 0.0f) {
        // On an edge, or a triangle too small for the products to tell: then its extent decides.
        vec3 least = min(a, min(b, c));
        vec3 most = max(a, max(b, c));
        if (max(least.x, least.y) > 0.0f || min(most.x, most.y) < 0.0f) return;
    }
    float t = (wa * a.z + wb * b.z + wc * c.z) / sum;
    if (!(t > beyond) || t > hit.t || (t == hit.t && first.w > hit.rank)) return;
    hit.t = t;
    hit.u = wb / sum;
    hit.v = wc / sum;
    hit.triangle = triangle;
    hit.rank = first.w;
}

/// 1 / x, finite: a ray that runs along a plane is taken as crossing it very far away.
TUKOR_FN float bvhReciprocal(float x) {
    return 1.0f / (abs(x) < 1e-12f ? (x < 0.0f ? -1e-12f : 1e-12f) : x);
}

TUKOR_FN vec4 bvhBytes(uint word) {
    return vec4(float(word & 255u), float((word >> 8u) & 255u), float((word >> 16u) & 255u),
                float(word >> 24u));
}

TUKOR_FN float bvhScale(uint exponents, uint axis) {
    return uintBitsToFloat(((exponents >> (8u * axis)) & 255u) << 23u);
}

/// The nearest triangle but `skip` that the ray meets at t in (beyond, reach); none if `triangle`
/// is -1. `beyond` is at least 0.
///
/// A ray that leaves a surface starts on its triangle and skips it. `direction` needs no unit
/// length.
TUKOR_FN BvhHit nearestBvhHit(TUKOR_BVH_PARAMETER vec3 origin, vec3 direction, float beyond,
                              float reach, int skip) {
    BvhHit hit = noBvhHit(reach);
    BvhRay ray = bvhRay(origin, direction);
    vec3 inverse =
        vec3(bvhReciprocal(direction.x), bvhReciprocal(direction.y), bvhReciprocal(direction.z));
    int stack[kBvhStackSize];
    int size = 0;
    int node = 0;
    while (node >= 0) {
        uvec4 frame = bvhNodeTexel(TUKOR_BVH_ARGUMENT 3 * node);
        uvec4 least = bvhNodeTexel(TUKOR_BVH_ARGUMENT 3 * node + 1);
        uvec4 most = bvhNodeTexel(TUKOR_BVH_ARGUMENT 3 * node + 2);

        // All four boxes at once: along each axis the plane that the ray meets first, and the
        // other.
        vec3 corner =
            vec3(uintBitsToFloat(frame.x), uintBitsToFloat(frame.y), uintBitsToFloat(frame.z));
        vec3 scale =
            vec3(bvhScale(frame.w, 0u), bvhScale(frame.w, 1u), bvhScale(frame.w, 2u)) * inverse;
        vec3 start = (corner - origin) * inverse;
        // Three roundings of at most 2^-24 each of these magnitudes here, and five in a triangle's
        // t, to be compared with it: a triangle is never met outside of its box.
        vec3 slack = (abs(start) + 256.0f * abs(scale)) * 6e-7f;
        vec3 enter = start - slack;
        vec3 leave = start + slack;
        bool forwardX = inverse.x > 0.0f;
        bool forwardY = inverse.y > 0.0f;
        bool forwardZ = inverse.z > 0.0f;
        vec4 nearX = bvhBytes(forwardX ? least.x : most.x) * scale.x + vec4(enter.x);
        vec4 nearY = bvhBytes(forwardY ? least.y : most.y) * scale.y + vec4(enter.y);
        vec4 nearZ = bvhBytes(forwardZ ? least.z : most.z) * scale.z + vec4(enter.z);
        vec4 farX = bvhBytes(forwardX ? most.x : least.x) * scale.x + vec4(leave.x);
        vec4 farY = bvhBytes(forwardY ? most.y : least.y) * scale.y + vec4(leave.y);
        vec4 farZ = bvhBytes(forwardZ ? most.z : least.z) * scale.z + vec4(leave.z);
        vec4 nearest = max(max(nearX, nearY), max(nearZ, vec4(0.0f)));
        vec4 farthest = min(min(farX, farY), farZ);

        // Leaves now; inner nodes sorted by distance, the nearest first.
        uint kinds = (least.w >> 24u) | ((most.w >> 24u) << 8u);
        int child = int(least.w & 0xFFFFFFu);
        int triangle = int(most.w & 0xFFFFFFu);
        int first = -1;
        int second = -1;
        int third = -1;
        int fourth = -1;
        float firstT = 0.0f;
        float secondT = 0.0f;
        float thirdT = 0.0f;
        float fourthT = 0.0f;
        for (int slot = 0; slot < 4; slot++) {
            uint kind = (kinds >> uint(4 * slot)) & 15u;
            float t = slot == 0   ? nearest.x
                      : slot == 1 ? nearest.y
                      : slot == 2 ? nearest.z
                                  : nearest.w;
            float end = slot == 0   ? farthest.x
                        : slot == 1 ? farthest.y
                        : slot == 2 ? farthest.z
                                    : farthest.w;
            bool met = t <= min(end, hit.t);
            if (kind == kBvhInner) {
                if (met) {
                    if (first < 0 || t < firstT) {
                        fourth = third;
                        fourthT = thirdT;
                        third = second;
                        thirdT = secondT;
                        second = first;
                        secondT = firstT;
                        first = child;
                        firstT = t;
                    } else if (second < 0 || t < secondT) {
                        fourth = third;
                        fourthT = thirdT;
                        third = second;
                        thirdT = secondT;
                        second = child;
                        secondT = t;
                    } else if (third < 0 || t < thirdT) {
                        fourth = third;
                        fourthT = thirdT;
                        third = child;
                        thirdT = t;
                    } else {
                        fourth = child;
                        fourthT = t;
                    }
                }
                child++;
            } else {
                if (met) {
                    for (int i = 0; i < int(kind); i++) {
                        if (triangle + i != skip)
                            bvhTriangle(TUKOR_BVH_ARGUMENT triangle + i, ray, beyond, hit);
                    }
                }
                triangle += int(kind);
            }
        }
        if (fourth >= 0 && fourthT <= hit.t) {
            stack[size] = fourth;
            size++;
        }
        if (third >= 0 && thirdT <= hit.t) {
            stack[size] = third;
            size++;
        }
        if (second >= 0 && secondT <= hit.t) {
            stack[size] = second;
            size++;
        }
        if (first >= 0 && firstT <= hit.t) {
            node = first;
        } else if (size > 0) {
            size--;
            node = stack[size];
        } else {
            node = -1;
        }
    }
    return hit;
}

/// What a hit lies on: a triangle with its corners' normals.
struct BvhSurface {
    vec3 v0;
    vec3 e1;  // v1 - v0
    vec3 e2;  // v2 - v0
    vec3 n0;
    vec3 n1;
    vec3 n2;
    int part;
    int rank;  // of the triangle in the source's order
};

TUKOR_FN BvhSurface bvhSurface(TUKOR_BVH_PARAMETER int triangle) {
    BvhSurface surface;
    vec4 first = bvhTriangleTexel(TUKOR_BVH_ARGUMENT 3 * triangle);
    vec4 normal = bvhNormalTexel(TUKOR_BVH_ARGUMENT 3 * triangle);
    surface.v0 = vec3(first);
    surface.e1 = vec3(bvhTriangleTexel(TUKOR_BVH_ARGUMENT 3 * triangle + 1)) - surface.v0;
    surface.e2 = vec3(bvhTriangleTexel(TUKOR_BVH_ARGUMENT 3 * triangle + 2)) - surface.v0;
    surface.n0 = vec3(normal);
    surface.n1 = vec3(bvhNormalTexel(TUKOR_BVH_ARGUMENT 3 * triangle + 1));
    surface.n2 = vec3(bvhNormalTexel(TUKOR_BVH_ARGUMENT 3 * triangle + 2));
    surface.part = int(normal.w);
    surface.rank = int(first.w);
    return surface;
}

TUKOR_SHARED_END
