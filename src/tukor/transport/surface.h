// A surface as a ray meets it: which side, which normal, and which way out of it. Shared source.
#pragma once
#include "tukor/optics/shared.h"

TUKOR_SHARED_BEGIN(transport)

/// Values of SurfaceHit::kind, those of MaterialKind.
TUKOR_CONST int kMirror = 0;
TUKOR_CONST int kMetal = 1;
TUKOR_CONST int kDielectric = 2;

/// What the host knows of the nearest triangle along a ray.
struct SurfaceHit {
    float distance;  // metres along the ray's unit direction
    vec3 position;   // v0 + u e1 + v e2: on the triangle, where the next ray starts without epsilon
    vec3 e1;         // v1 - v0; the winding is counter-clockwise from outside
    vec3 e2;         // v2 - v0
    vec3 normal;     // interpolated, of any length
    vec3 normalE1;   // n1 - n0: the change of `normal` along e1
    vec3 normalE2;   // n2 - n0
    int triangle;    // the host's name for it, >= 0; the next ray must not hit it again
    int kind;
    vec3 tint;     // reflectance; mirrors only
    vec3 eta;      // index eta + i k against vacuum; metals only
    vec3 k;        //
    uint inside;   // media set behind the surface, one bit each; dielectrics only
    uint outside;  // media set before it: 0 but where one sheet parts two dielectrics
};

/// The surface turned towards the ray.
struct Facing {
    vec3 n;           // shading normal, unit, dot(d, n) < 0
    vec3 ng;          // geometric normal, unit, dot(d, ng) <= 0
    float cosThetaI;  // -dot(d, n), in (0, 1]
    float side;       // 1 met from outside, -1 from inside
    bool front;
};

/// The unit normal of a triangle by its winding, also of tiny ones; the null vector if it has no
/// area.
TUKOR_FN vec3 geometricNormal(vec3 e1, vec3 e2) {
    vec3 area = cross(e1, e2);
    float l2 = dot(area, area);
    if (l2 > 1e-30f && l2 < 1e30f) return area * inversesqrt(l2);
    // Of less than 1e-15 square metres, or far too many: scaled, so that squares stay in range.
    vec3 most = max(abs(e1), abs(e2));
    float size = max(most.x, max(most.y, most.z));
    if (!(size > 0.0f)) return vec3(0.0f);
    area = cross(e1 / size, e2 / size);
    l2 = dot(area, area);
    return l2 > 0.0f ? area * inversesqrt(l2) : vec3(0.0f);
}

/// Sides go by the triangle itself, angles by the interpolated normal. Where that one is turned
/// away from the ray, at silhouettes, the triangle's own takes its place.
TUKOR_FN Facing facingSurface(SurfaceHit hit, vec3 d) {
    Facing face;
    vec3 ng = geometricNormal(hit.e1, hit.e2);
    float slope = dot(d, ng);
    face.front = slope <= 0.0f;
    face.side = face.front ? 1.0f : -1.0f;
    ng = slope == 0.0f ? -d : ng * face.side;  // a sliver without area faces the ray
    float l2 = dot(hit.normal, hit.normal);
    vec3 n = l2 > 0.0f ? hit.normal * (face.side * inversesqrt(l2)) : ng;
    float c = -dot(d, n);
    if (!(c >= 1e-4f)) {  // 0.006 degrees from grazing: R is 1 there anyway
        n = ng;
        c = -dot(d, n);
    }
    face.n = n;
    face.ng = ng;
    face.cosThetaI = clamp(c, 1e-6f, 1.0f);
    return face;
}

/// `w`, or its mirror image across the facet plane if it lies on the wrong side of it: `sign` is 1
/// for reflected, -1 for refracted directions. Discarding them instead makes black pixels.
TUKOR_FN vec3 onSide(vec3 w, vec3 ng, float sign) {
    float height = dot(w, ng) * sign;
    if (height > 0.0f) return w;
    // 1e-4: out of the plane itself, where the ray would run along its own surface
    return normalize(w + ((1e-4f - 2.0f * height) * sign) * ng);
}

TUKOR_SHARED_END
