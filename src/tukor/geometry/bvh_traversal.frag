#version 300 es
// The smallest host of the traversal: the distance along one ray a pixel. It exists to be compiled: glslangValidator proves with
// it that the shared source is GLSL ES 3.00.
#include "tukor/geometry/bvh_traversal.h"

uniform vec3 uOrigin;
in vec3 vDirection;
out vec4 oColor;

void main() {
    BvhHit hit = nearestBvhHit(uOrigin, vDirection, 0.0, 1e30, -1);
    oColor = vec4(0.0);
    if (hit.triangle >= 0) {
        BvhSurface surface = bvhSurface(hit.triangle);
        oColor = vec4(surface.n0 + hit.u * (surface.n1 - surface.n0) + hit.v * (surface.n2 - surface.n0), hit.t);
    }
}
