#version 300 es
// Fidelity `single` of rough, diffuse and textured surfaces: the split sum, of exactly filtered light
// from all around and a table of what the surface makes of it. Nothing shadows anything.
//
// SOLID: 1 bends what it lets in, 0 is a thin sheet. ALPHA_MODE: 0 opaque, 1 mask, 2 blend.
// UNLIT, CLEARCOAT, SHEEN, ANISOTROPIC, FILM, TRANSMISSIVE: what it has. MAP_...: its textures, numbered as
// TextureRole has them.
#include "tukor/gl/shaders/environment.glsl"
#include "tukor/gl/shaders/lamplight.glsl"
#include "tukor/gl/shaders/split_sum.glsl"
#include "tukor/optics/directions.h"
#include "tukor/optics/fresnel.h"
#include "tukor/optics/microfacet.h"
#include "tukor/optics/thin_film.h"
uniform vec4 places[32];  // of each texture: its matrix, by columns, and its set of coordinates
uniform sampler2D map0, map1, map2, map3, map4, map5, map6, map7;
uniform sampler2D map8, map9, map10, map11, map12, map13, map14, map15;
uniform vec4 baseColor;
uniform float alphaCutoff;
uniform vec2 metallicRoughness;
uniform vec3 emission;
uniform float unlitFactor;
uniform float normalScale;
uniform float occlusionStrength;
uniform vec3 specularF0;
uniform float specularWeight;
uniform float transmission;
uniform float eta;
uniform vec3 coat;  // share, roughness, scale of its normal map
uniform vec4 sheen;
uniform vec2 anisotropy;
uniform vec4 film;
in vec3 fromEye;
in vec3 normal;
in vec4 uv;
in vec4 tangent;
in vec4 color;
out vec4 fragmentColor;

#define LOOK(map, role) texture(map, placeOf(role))

vec2 placeOf(int role) {
    vec4 more = places[2 * role + 1];
    vec2 p = more.z < 0.5 ? uv.xy : uv.zw;
    vec4 m = places[2 * role];
    return m.xy * p.x + m.zw * p.y + more.xy;
}

// Of the front side, from the mesh or along the first texture's coordinates.
TangentFrame frameOf(vec3 n, bool front) {
    TangentFrame f;
    f.n = n;
    f.t = tangent.xyz - dot(tangent.xyz, n) * n;
    float handed = tangent.w < 0.0 ? -1.0 : 1.0;
    vec3 px = dFdx(fromEye), py = dFdy(fromEye);
#ifdef MAP_NORMAL
    vec2 place = places[5].z < 0.5 ? uv.xy : uv.zw;
#else
    vec2 place = uv.xy;
#endif
    vec2 ux = dFdx(place), uy = dFdy(place);
    if (dot(f.t, f.t) < 1e-6) {
        float det = ux.x * uy.y - ux.y * uy.x;
        vec3 perU = (px * uy.y - py * ux.y) * sign(det);
        vec3 perV = (py * ux.x - px * uy.x) * sign(det);
        f.t = perU - dot(perU, n) * n;
        // v runs down the picture, the bitangent up.
        handed = dot(cross(n, f.t), perV) > 0.0 ? -1.0 : 1.0;
    }
    float l2 = dot(f.t, f.t);
    if (!(l2 > 1e-16)) f.t = abs(n.x) < 0.5 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0);
    f.t = normalize(f.t - dot(f.t, n) * n);
    f.b = cross(n, f.t) * handed;
    return f;
}

vec3 perturbed(TangentFrame f, vec3 texel, float scale) {
    vec3 m = texel * 2.0 - 1.0;
    return normalize(m.x * scale * f.t + m.y * scale * f.b + m.z * f.n);
}

// On the viewer's side, as far as need be.
vec3 turnedTo(vec3 n, vec3 wo) {
    float c = dot(n, wo);
    return c >= 1e-3 ? n : normalize(n + (2e-3 - c) * wo);
}

void main() {
    vec4 base = baseColor * color;
#ifdef MAP_BASE_COLOR
    base *= LOOK(map0, 0);
#endif
#if ALPHA_MODE == 0
    base.a = 1.0;
#elif ALPHA_MODE == 1
    if (base.a < alphaCutoff) discard;
    base.a = 1.0;
#endif
#ifdef UNLIT
    fragmentColor = vec4(base.rgb * (base.a * unlitFactor), base.a);
#else
    vec3 wo = -normalize(fromEye);
    TangentFrame frame = frameOf(normalize(normal), gl_FrontFacing);
    float side = gl_FrontFacing ? 1.0 : -1.0;
    vec3 n = frame.n;
#ifdef MAP_NORMAL
    n = perturbed(frame, LOOK(map2, 2).rgb, normalScale);
#endif
    n = turnedTo(side * n, wo);
    float metallic = metallicRoughness.x;
    float roughness = metallicRoughness.y;
#ifdef MAP_METALLIC_ROUGHNESS
    vec4 figures = LOOK(map1, 1);
    metallic *= figures.b;
    roughness *= figures.g;
#endif
    float weight = specularWeight;
    vec3 F0 = specularF0;
#ifdef MAP_SPECULAR
    weight *= LOOK(map6, 6).a;
#endif
#ifdef MAP_SPECULAR_COLOR
    F0 *= LOOK(map7, 7).rgb;
#endif
    F0 = min(F0, vec3(1.0)) * weight;
    vec3 metalF0 = base.rgb;
    float cosThetaI = clamp(dot(n, wo), 0.0, 1.0);
#ifdef FILM
    float share = film.x;
    float thickness = film.w;
#ifdef MAP_IRIDESCENCE
    share *= LOOK(map14, 14).r;
#endif
#ifdef MAP_IRIDESCENCE_THICKNESS
    thickness = mix(film.z, film.w, LOOK(map15, 15).g);
#endif
    F0 = mix(F0, filmAtNormal(cosThetaI, film.y, thickness, F0), share);
    metalF0 = mix(metalF0, filmAtNormal(cosThetaI, film.y, thickness, metalF0), share);
#endif

    vec3 around = n;
#ifdef ANISOTROPIC
    float strength = anisotropy.x;
    float turn = anisotropy.y;
#ifdef MAP_ANISOTROPY
    vec3 direction = LOOK(map13, 13).rgb;
    strength *= direction.b;
    turn += atan(2.0 * direction.g - 1.0, 2.0 * direction.r - 1.0);
#endif
    // Bent towards the view across the stretched direction. [McAuley 2015]
    vec3 along = cos(turn) * frame.t + sin(turn) * frame.b;
    vec3 across = cross(cross(normalize(cross(n, along)), wo), normalize(cross(n, along)));
    float bend = 1.0 - strength * (1.0 - roughness);
    around = normalize(mix(normalize(across), n, bend * bend * bend * bend));
#endif
    vec3 reflected = reflectDirection(-wo, around);
    // Seen far off its mirror direction a rough surface sees most around its normal.
    vec3 main = mix(reflected, n, roughness * roughness * roughness * roughness);
    vec3 specularLight = blurred(main, roughness, footprintRadiance(reflected));
    vec2 terms = split(cosThetaI, roughness).rg;
    vec3 metalR = compensatedReflectance(metalF0, vec3(1.0), terms);
    vec3 matR = compensatedReflectance(F0, vec3(weight), terms);
    vec3 irradiance = textureLod(chain, n, lastLevel).rgb;  // over pi
    vec3 matt = base.rgb * irradiance;
#ifdef TRANSMISSIVE
    float entering = transmission;
#ifdef MAP_TRANSMISSION
    entering *= LOOK(map5, 5).r;
#endif
    vec3 ahead = -wo;
#if SOLID == 1
    Refraction refraction = refractDirection(-wo, n, gl_FrontFacing ? eta : 1.0 / eta);
    ahead = refraction.total ? reflected : refraction.direction;
#endif
    matt = mix(matt, base.rgb * blurred(ahead, roughness, footprintRadiance(ahead)), entering);
#endif
    vec3 L = metallic * metalR * specularLight +
             (1.0 - metallic) * (matR * specularLight + (vec3(1.0) - matR) * matt);
#ifdef LAMPS
    TangentFrame turned = frame;
    turned.n = n;
    turned.t = normalize(frame.t - dot(frame.t, n) * n);
    turned.b = cross(n, turned.t);
    float alpha = max(roughness * roughness, 1e-3);
    Lamplight lit = lamplight(turned, wo, vec2(alpha), fromEye);
    vec3 lampBase = (vec3(1.0) - matR) * base.rgb;
#ifdef TRANSMISSIVE
    lampBase *= 1.0 - entering;
#endif
    L += lampLook(lit, terms, metallic, metalF0, F0, weight, lampBase);
#endif

#ifdef SHEEN
    vec4 fibres = sheen;
#ifdef MAP_SHEEN_COLOR
    fibres.rgb *= LOOK(map11, 11).rgb;
#endif
#ifdef MAP_SHEEN_ROUGHNESS
    fibres.a *= LOOK(map12, 12).a;
#endif
    float strongest = max(fibres.r, max(fibres.g, fibres.b));
    float fibreR = min(split(cosThetaI, fibres.a).b, 1.0 / max(strongest, 1e-3));
    L = L * (1.0 - strongest * fibreR) + fibres.rgb * fibreR * irradiance;
#endif
#ifdef CLEARCOAT
    vec3 coatNormal = side * frame.n;
    vec2 layer = coat.xy;
#ifdef MAP_CLEARCOAT
    layer.x *= LOOK(map8, 8).r;
#endif
#ifdef MAP_CLEARCOAT_ROUGHNESS
    layer.y *= LOOK(map9, 9).g;
#endif
#ifdef MAP_CLEARCOAT_NORMAL
    coatNormal = side * perturbed(frame, LOOK(map10, 10).rgb, coat.z);
#endif
    coatNormal = turnedTo(coatNormal, wo);
    float coatCos = clamp(dot(coatNormal, wo), 0.0, 1.0);
    float coatR = layer.x * compensatedReflectance(vec3(0.04), vec3(1.0), split(coatCos, layer.y).rg).x;
    vec3 mirrored = reflectDirection(-wo, coatNormal);
    L = L * (1.0 - coatR) + coatR * blurred(mirrored, layer.y, footprintRadiance(mirrored));
#endif
#ifdef MAP_OCCLUSION
    L *= mix(1.0, LOOK(map3, 3).r, occlusionStrength);
#endif
    vec3 Le = emission;
#ifdef MAP_EMISSION
    Le *= LOOK(map4, 4).rgb;
#endif
    fragmentColor = vec4((L + Le) * base.a, base.a);
#endif
}
