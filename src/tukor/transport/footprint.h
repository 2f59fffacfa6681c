// How wide a ray is: ray differentials through every event of a path. Shared source.
//
// A footprint holds the change of a ray's origin and direction per pixel (or per sample) in x and
// y. [Igehy 1999]
#pragma once
#include "tukor/transport/surface.h"

TUKOR_SHARED_BEGIN(transport)

struct Footprint {
    vec3 originX;
    vec3 originY;
    vec3 directionX;
    vec3 directionY;
};

/// An infinitely thin ray: look-ups at full resolution.
TUKOR_FN Footprint thinFootprint() {
    Footprint f;
    f.originX = vec3(0.0f);
    f.originY = vec3(0.0f);
    f.directionX = vec3(0.0f);
    f.directionY = vec3(0.0f);
    return f;
}

/// A ray that may end up anywhere about `d`: half a radian about it.
TUKOR_FN Footprint wideFootprint(vec3 d) {
    Footprint f = thinFootprint();
    vec3 side = abs(d.x) < 0.6f ? vec3(1.0f, 0.0f, 0.0f) : vec3(0.0f, 1.0f, 0.0f);
    f.directionX = 0.5f * normalize(cross(d, side));
    f.directionY = cross(d, f.directionX);
    return f;
}

/// A camera ray's: all rays leave the eye. `direction` is not normalised and changes by `dx` and
/// `dy` from one sample to the next.
TUKOR_FN Footprint cameraFootprint(vec3 direction, vec3 dx, vec3 dy) {
    Footprint f = thinFootprint();
    float l2 = dot(direction, direction);
    float scale = inversesqrt(l2) / l2;
    f.directionX = (dx * l2 - direction * dot(direction, dx)) * scale;
    f.directionY = (dy * l2 - direction * dot(direction, dy)) * scale;
    return f;
}

/// Steradians that the directions of the ray cover; 0 where the differentials overflowed.
TUKOR_FN float footprintSolidAngle(Footprint f) {
    vec3 area = cross(f.directionX, f.directionY);
    float a2 = dot(area, area);
    return a2 < 1e30f ? sqrt(a2) : 0.0f;
}

/// The mip level at which a footprint of `solidAngle` is one texel of a cube map wide.
///
/// From the area: long thin footprints stay sharp. At most 4, i.e. 16 texels: linear
/// extrapolation over more does harm, and the samples of a pixel cover what is missing.
TUKOR_FN float footprintLevel(float solidAngle, int faceSize) {
    float texels = solidAngle * float(faceSize) * float(faceSize) * 0.47746483f;  // 6 / (4 pi)
    return clamp(0.5f * log2(max(texels, 1e-6f)), 0.0f, 4.0f);
}

/// Along the ray to a surface with unit normal `ng` at `distance`.
TUKOR_FN Footprint footprintAtSurface(Footprint f, vec3 d, float distance, vec3 ng) {
    float slope = min(dot(d, ng), -1e-4f);  // grazing: keeps the footprint within 10^4 pixels
    vec3 x = f.originX + distance * f.directionX;
    vec3 y = f.originY + distance * f.directionY;
    f.originX = x - (dot(x, ng) / slope) * d;
    f.originY = y - (dot(y, ng) / slope) * d;
    return f;
}

/// The change of the unit shading normal over a footprint in the plane of the triangle, per pixel
/// in x and y.
struct NormalChange {
    vec3 x;
    vec3 y;
};

TUKOR_FN NormalChange normalChangeOver(Footprint f, SurfaceHit hit, Facing face) {
    vec3 area = cross(hit.e1, hit.e2);
    float scale = 1.0f / dot(area, area);
    vec3 u = cross(hit.e2, area) * scale;  // the gradients of the barycentric coordinates
    vec3 v = cross(area, hit.e1) * scale;
    float turn = face.side / length(hit.normal);
    vec3 perU = turn * (hit.normalE1 - dot(hit.normalE1, face.n) * face.n);
    vec3 perV = turn * (hit.normalE2 - dot(hit.normalE2, face.n) * face.n);
    NormalChange n;
    n.x = dot(f.originX, u) * perU + dot(f.originX, v) * perV;
    n.y = dot(f.originY, u) * perU + dot(f.originY, v) * perV;
    return n;
}

/// After reflection of `d` at the surface; `f` is the footprint at the surface.
TUKOR_FN Footprint reflectedFootprint(Footprint f, NormalChange n, Facing face, vec3 d) {
    float c = dot(d, face.n);
    float cx = dot(f.directionX, face.n) + dot(d, n.x);
    float cy = dot(f.directionY, face.n) + dot(d, n.y);
    f.directionX = f.directionX - 2.0f * (c * n.x + cx * face.n);
    f.directionY = f.directionY - 2.0f * (c * n.y + cy * face.n);
    return f;
}

/// After refraction of `d` into a medium of `eta` = etaT / etaI.
TUKOR_FN Footprint refractedFootprint(Footprint f, NormalChange n, Facing face, vec3 d, float eta,
                                      float cosThetaT) {
    float r = 1.0f / eta;
    float c = dot(d, face.n);
    float ct = -max(cosThetaT, 0.02f);  // the derivative is infinite at the critical angle
    float m = r * c - ct;
    float dm = r - r * r * c / ct;
    float cx = dot(f.directionX, face.n) + dot(d, n.x);
    float cy = dot(f.directionY, face.n) + dot(d, n.y);
    f.directionX = r * f.directionX - (m * n.x + (dm * cx) * face.n);
    f.directionY = r * f.directionY - (m * n.y + (dm * cy) * face.n);
    return f;
}

TUKOR_SHARED_END
