// Where a ray meets a sphere, in closed form: no triangle, no epsilon. Shared source.
//
// A ray that leaves a sphere starts on it: the root there is known and left out, not found and
// rejected.
#pragma once
#include "tukor/optics/shared.h"

TUKOR_SHARED_BEGIN(geometry)

/// What "nothing" is to sphereDistance.
TUKOR_CONST float kSphereMissed = -1.0f;

/// Metres along the unit `d` to the nearest point of the sphere beyond `beyond`; kSphereMissed if
/// there is none. `leaves`: the ray starts on this very sphere, and the other end of its chord is
/// meant. [Haines, Guenther and Akenine-Moeller 2019, the discriminant by the chord's distance]
TUKOR_FN float sphereDistance(vec3 origin, vec3 d, vec3 centre, float radius, float beyond,
                              bool leaves) {
    vec3 f = origin - centre;
    float b = -dot(f, d);
    if (leaves) {
        // Rounding puts the origin beside the sphere; only where the host moved it inwards does
        // the difference count.
        float c = dot(f, f) - radius * radius;
        if (abs(c) < 1e-5f * radius * radius) c = 0.0f;
        float end = b + sqrt(max(b * b - c, 0.0f));
        return end > beyond ? end : kSphereMissed;
    }
    vec3 l = f + b * d;
    float h2 = radius * radius - dot(l, l);
    if (!(h2 >= 0.0f)) return kSphereMissed;
    float h = sqrt(h2);
    if (b - h > beyond) return b - h;
    return b + h > beyond ? b + h : kSphereMissed;
}

/// The sphere at a point: a frame whose first two axes are one radius long and span the tangent
/// plane, counter-clockwise seen from outside.
struct SpherePoint {
    vec3 position;  // on the sphere
    vec3 e1;
    vec3 e2;
    vec3 normal;  // unit, outwards; its change along e1 is e1 / radius
};

/// Of the point `distance` along the ray.
TUKOR_FN SpherePoint spherePoint(vec3 origin, vec3 d, float distance, vec3 centre, float radius) {
    SpherePoint p;
    p.normal = normalize(origin + distance * d - centre);
    p.position = centre + radius * p.normal;
    vec3 axis = abs(p.normal.x) < 0.5f ? vec3(1.0f, 0.0f, 0.0f) : vec3(0.0f, 1.0f, 0.0f);
    p.e1 = radius * normalize(cross(axis, p.normal));
    p.e2 = cross(p.normal, p.e1);
    return p;
}

TUKOR_SHARED_END
