// Where single precision meets a surface from the wrong side, or misses it: one ray in a million,
// at edges. Shared source: what the host does about it.
//
//     Rounding rounding = exactSoFar();
//     do find the nearest triangle at t > rounding.beyond along tree.branch;
//     while (triesAgain(rounding, tree.branch, found, t, nearness, whether path and surface
//     agree));
//
// after each of which the host moves the branch's origin to nudgedOrigin() if rounding.nudged says
// so. What is met is taken to be met at awayFromEdges().
#pragma once
#include "tukor/transport/branch.h"
#include "tukor/transport/surface.h"

TUKOR_SHARED_BEGIN(transport)

/// In barycentric coordinates: rays meet edges with an error of some 1e-7 of the distance, and a
/// thousandth of that is a small triangle.
TUKOR_CONST float kEdge = 1e-4f;

/// Triangles whose common corner a ray passes.
TUKOR_CONST int kMostAtCorner = 8;

/// What has been tried so far for one ray.
struct Rounding {
    float beyond;  // metres along the ray; 0 the first time
    int tries;
    bool nudged;  // the ray is to start a little further within its own triangle
};

TUKOR_FN Rounding exactSoFar() {
    Rounding r;
    r.beyond = 0.0f;
    r.tries = 0;
    r.nudged = false;
    return r;
}

/// How near its edges a triangle was met, in barycentric coordinates as they look along the ray
/// `d`.
TUKOR_FN float nearnessToEdge(float u, float v, vec3 d, vec3 ng) {
    return min(min(u, v), 1.0f - u - v) * abs(dot(d, ng));
}

/// By how much a position is off the surface on which it lies, and more, in metres.
TUKOR_FN float roundingAt(vec3 position) {
    vec3 far = abs(position);
    return 4e-7f * max(far.x, max(far.y, far.z));
}

/// Where a ray begins that leaves a surface at `position`: a rounding before it, so that another
/// surface there, as where two solids intersect, is not behind it.
TUKOR_FN vec3 leavingFrom(vec3 position, vec3 d) {
    return position - roundingAt(position) * d;
}

/// Where in a triangle a ray that met it at (u, v) goes on: never at its very edge, where rounding
/// would decide whether the next ray begins before or beyond the neighbouring triangle.
TUKOR_FN vec2 awayFromEdges(float u, float v) {
    bool near = min(min(u, v), 1.0f - u - v) < kEdge;
    return near ? mix(vec2(u, v), vec2(1.0f / 3.0f), 3.0f * kEdge) : vec2(u, v);
}

/// Where a ray in direction `d` begins instead: a little further within the triangle v0, e1, e2
/// that it leaves, and off it, to the side where it goes, by what positions are rounded by.
TUKOR_FN vec3 nudgedOrigin(vec3 origin, vec3 d, vec3 v0, vec3 e1, vec3 e2) {
    vec3 ng = geometricNormal(e1, e2);
    float height = dot(d, ng) < 0.0f ? -roundingAt(origin) : roundingAt(origin);
    return mix(origin, v0 + (e1 + e2) / 3.0f, kEdge) + height * ng;
}

/// Whether what was found at `t`, `nearness` to an edge, or nothing if not `found`, may come of
/// rounding; then `rounding` says where to look instead. `agrees`: the path is on the side of the
/// surface on which it believes to be, or sees the environment from outside of everything. Where no
/// try agrees the last is the first again: the model is at fault.
TUKOR_FN bool triesAgain(TUKOR_INOUT(Rounding) rounding, Branch ray, bool found, float t,
                         float nearness, bool agrees) {
    int last = kMostAtCorner + 2;
    if (agrees || rounding.tries >= last) return false;
    bool behind = ray.skip >= 0 && t < 2.0f * roundingAt(ray.origin);
    bool onEdge = found && (nearness < kEdge || behind);
    if (rounding.tries == 0 && ray.skip < 0 && !onEdge) return false;
    rounding.nudged = false;
    if (rounding.tries < kMostAtCorner && onEdge) {
        // A ray that starts at an edge may meet the neighbouring triangle at once, or what it met
        // before, and one that passes a silhouette the triangle behind it: look further along the
        // ray.
        rounding.beyond = t;
        rounding.tries = rounding.tries + 1;
        return true;
    }
    rounding.beyond = 0.0f;
    if (rounding.tries <= kMostAtCorner && ray.skip >= 0) {
        // Or it starts beyond the neighbour that it should meet.
        rounding.nudged = true;
        rounding.tries = kMostAtCorner + 1;
    } else {
        rounding.tries = last;
    }
    return true;
}

TUKOR_SHARED_END
