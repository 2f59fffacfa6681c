#version 300 es
// Fidelity `single`: lecture rows 10 to 14 at the first surface, nothing behind it.
//
// MATERIAL: 0 mirror, 1 metal, 2 dielectric. FRESNEL: 0 exact, 1 the lecture's approximation.
#include "tukor/gl/shaders/environment.glsl"
#include "tukor/optics/directions.h"
#include "tukor/optics/fresnel.h"
uniform vec3 tint;
uniform vec3 eta;
uniform vec3 k;
in vec3 fromEye;
in vec3 normal;
out vec4 fragmentColor;

// The shading normal on the viewer's side of the facet; the facet's own where the interpolated one
// is turned away, at silhouettes. Row 12 goes by the side of the facet that is seen.
vec3 facingNormal(vec3 d, bool front) {
    vec3 facet = normalize(cross(dFdx(fromEye), dFdy(fromEye)));
    facet = dot(d, facet) > 0.0 ? -facet : facet;
    vec3 n = normalize(normal);
    n = front ? n : -n;
    return -dot(d, n) < 1e-4 ? facet : n;
}

void main() {
    vec3 d = normalize(fromEye);
    vec3 n = facingNormal(d, gl_FrontFacing);
    float cosThetaI = clamp(-dot(d, n), 0.0, 1.0);
    vec3 reflected = footprintRadiance(reflectDirection(d, n));
#if MATERIAL == 0
    fragmentColor = vec4(tint * reflected, 1.0);
#elif MATERIAL == 1
#if FRESNEL == 0
    vec3 R = fresnelConductor(cosThetaI, eta, k);
#else
    vec3 R = fresnelSchlick(cosThetaI, reflectanceAtNormal(eta, k));
#endif
    fragmentColor = vec4(R * reflected, 1.0);
#else
    float across = gl_FrontFacing ? eta.x : 1.0 / eta.x;
    Refraction refraction = refractDirection(d, n, across);
#if FRESNEL == 0
    float R = fresnelDielectric(cosThetaI, across);
#else
    // From inside, the cosine on the thin side: there the approximation is meant to be used.
    float thin = across < 1.0 ? refraction.cosThetaT : cosThetaI;
    float R = fresnelSchlick(thin, reflectanceAtNormal(vec3(across), vec3(0.0))).x;
#endif
    R = refraction.total ? 1.0 : R;
    vec3 refracted = footprintRadiance(refraction.direction);
    fragmentColor = vec4(R * reflected + (1.0 - R) * refracted, 1.0);
#endif
}
