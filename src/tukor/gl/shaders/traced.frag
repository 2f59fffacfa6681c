#version 300 es
// Fidelity `double` and `exact`: the light-path tree of one camera ray a pixel, traced through the
// triangles of the scene. The host of tukor/transport/path_tree.h in GLSL.
//
// FIDELITY and FRESNEL are those of the transport: compilers leave out the rest. COUNTING: 1 adds a second output with what
// happened on the way. DISPERSION: some media refract each wavelength in another way. GROUND: there is
// one, see below. FINISHES: there are surfaces that are not ideally smooth; what the camera sees of them was drawn before.
#include "tukor/gl/shaders/environment.glsl"
#include "tukor/geometry/bvh_traversal.h"
#include "tukor/geometry/sphere_hit.h"
#include "tukor/optics/dispersion.h"
#include "tukor/transport/grazing.h"
#include "tukor/transport/look_ups.h"
#include "tukor/transport/path_tree.h"
#include "tukor/transport/rounding.h"
#include "tukor/transport/sampler.h"

uniform vec3 eye;
uniform vec3 rayCorner;     // direction through the viewport's bottom-left corner, any length
uniform vec3 rayPerColumn;  // its change from one pixel to the next
uniform vec3 rayPerRow;
uniform float footprintScale;  // distance of neighbouring samples, in pixels
uniform mat3 environmentFromWorld;
uniform int environmentFaceSize;
uniform bool background;  // false: nothing is seen where the camera ray meets nothing

uniform uint eyeMedia;   // what the eye is inside of
uniform vec4 media[32];  // index against vacuum and absorption of the dielectrics
uniform usampler2D surfaces;  // nine texels a part, see traced_scene.cpp and finish_hit.glsl

// Parts that are whole spheres, two each: centre and radius; number of the part. They are not in the tree, and sphere i is
// called kFirstSphere + i.
const int kFirstSphere = 1 << 28;
uniform int sphereCount;
uniform vec4 spheres[16];

#ifdef GROUND
// The ground shows what is behind it, less what things hide of the light on it, and with what they throw on it. For both a ray
// leaves it: one asks whether light from somewhere arrives, one catches what comes from things.
uniform vec4 ground;            // the middle of a square, half its width
uniform vec3 groundIrradiance;  // where nothing shadows it
uniform sampler2D lit;          // 4096 directions from which it is lit, and the irradiance if all were as that
const int kAsking = -2;         // in place of what those rays leave
const int kCatching = -3;
const float kPi = 3.14159265;

// Views that move, of one sample a pixel, show the light on it that was gathered before, by place; see ground_light.h. What
// gathers has texels in place of pixels.
uniform int groundUse;
const int kTraced = 0;
const int kKnown = 1;
const int kGathered = 2;
uniform sampler2D groundLight;  // the share of what nothing shadows, and in alpha how much is hidden
uniform float groundLevel;      // of it to look at: the fewer samples, the smoother

// From the middle to where texels are four times as long: one and a half radii of the scene.
float groundDetail() {
    return 0.03 * ground.w;
}

vec2 groundTexel(vec3 place) {
    vec2 x = (place.xz - ground.xz) / groundDetail();
    return 0.5 + 0.5 * x / (1.0 + abs(x));
}

// From above to that texel.
Branch groundRay(Branch ray, vec2 texel) {
    vec2 x = 2.0 * texel - 1.0;
    x *= groundDetail() / (1.0 - abs(x));
    ray.origin = ground.xyz + vec3(x.x, groundDetail(), x.y);
    ray.direction = vec3(0.0, -1.0, 0.0);
    ray.footprint = thinFootprint();
    ray.media = 0u;
    return ray;
}

// Metres until a ray meets it from above; negative: not at all.
float groundDistance(Branch ray) {
    if (ray.media != 0u || !(ray.direction.y < 0.0)) return -1.0;
    float t = (ground.y - ray.origin.y) / ray.direction.y;
    vec3 there = abs(ray.origin + t * ray.direction - ground.xyz);
    return max(there.x, there.z) < ground.w ? t : -1.0;
}

// Asks for one of the directions from which it is lit.
Branch askingRay(Branch at, uint place) {
    ivec2 texel = ivec2(2u * (place & 63u), place >> 6u & 63u);
    at.direction = texelFetch(lit, texel, 0).xyz * environmentFromWorld;
    at.throughput *= texelFetch(lit, texel + ivec2(1, 0), 0).rgb;
    at.skip = kAsking;
    return at;
}

// In proportion to the cosine.
Branch catchingRay(Branch at, vec2 u) {
    float angle = 2.0 * kPi * u.y;
    at.direction = vec3(sqrt(u.x) * cos(angle), sqrt(max(1.0 - u.x, 1e-8)), sqrt(u.x) * sin(angle));
    at.throughput *= kPi;
    at.footprint = thinFootprint();
    float spread = min(footprintScale * sqrt(kPi / at.direction.y), kWidestFootprint);
    vec3 side = normalize(cross(abs(at.direction.x) < 0.5 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0), at.direction));
    at.footprint.directionX = spread * side;
    at.footprint.directionY = spread * cross(at.direction, side);
    at.skip = kCatching;
    return at;
}
#endif

uniform int rayBudget;
uniform int maxDepth;
uniform float weightCutoff;
uniform uint frame;
uniform bool splitGrazing;  // see grazing.h
uniform bool centred;      // samples lie in the middles of pixels
uniform bool firstHitsKnown;  // what they show is known:
uniform isampler2D firstHits;  // the number of the triangle, -1 for none
uniform uint pictureSeed;
uniform ivec2 topLeft;     // of the window's pixels in the picture
uniform ivec2 windowSize;
uniform int pictureWidth;

uniform sampler2D sum;  // of the frames before
uniform bool first;     // there are none
layout(location = 0) out vec4 fragmentColor;
#if COUNTING == 1
uniform sampler2D counted;
layout(location = 1) out vec4 counts;  // rays, leaks, inconsistencies, truncated
#endif

#ifdef DISPERSION
uniform vec4 dispersions[8];  // of the media, four to a vector: 20 over Abbe's number
uniform vec4 spectrum[65];    // nm and weights, see tukor/optics/spectrum.h
float wavelength;             // of the light that is traced, in nm; 0 for all

float dispersionOf(int number) {
    return number == kVacuum ? 0.0 : dispersions[number >> 2][number & 3];
}
#endif

#ifdef FINISHES
#include "tukor/gl/shaders/finish_hit.glsl"
#endif

const int kUnknown = -2;

// `known`, unless that is kUnknown or the ray passes just beside it.
BvhHit nearestTriangle(Branch ray, float beyond, int known) {
    BvhHit hit = noBvhHit(1e30);
    if (known >= 0) bvhTriangle(known, bvhRay(ray.origin, ray.direction), beyond, hit);
    if (known == -1 || hit.triangle >= 0) return hit;
    return nearestBvhHit(ray.origin, ray.direction, beyond, 1e30, ray.skip);
}

// The nearest sphere or triangle. A sphere is met in the middle of its one triangle.
BvhHit nearestHit(Branch ray, float beyond, int known) {
    BvhHit hit = nearestTriangle(ray, beyond, known);
    for (int i = 0; i < sphereCount; i++) {
        int name = kFirstSphere + i;
        float t = sphereDistance(ray.origin, ray.direction, spheres[2 * i].xyz, spheres[2 * i].w, beyond, ray.skip == name);
        if (t > 0.0 && t < hit.t) {
            hit.t = t;
            hit.u = 1.0 / 3.0;
            hit.v = 1.0 / 3.0;
            hit.triangle = name;
        }
    }
    return hit;
}

int partOf(int triangle) {
    if (triangle >= kFirstSphere) return int(spheres[2 * (triangle - kFirstSphere) + 1].x);
    return bvhSurface(max(triangle, 0)).part;
}

// That of triangle 0 where none was found.
SurfaceHit surfaceHit(BvhHit found, Branch ray) {
    SurfaceHit hit;
    if (found.triangle >= kFirstSphere) {
        vec4 sphere = spheres[2 * (found.triangle - kFirstSphere)];
        SpherePoint p = spherePoint(ray.origin, ray.direction, found.t, sphere.xyz, sphere.w);
        hit.position = p.position;
        hit.e1 = p.e1;
        hit.e2 = p.e2;
        hit.normalE1 = p.e1 / sphere.w;
        hit.normalE2 = p.e2 / sphere.w;
        hit.normal = p.normal;
    } else {
        BvhSurface triangle = bvhSurface(max(found.triangle, 0));
        vec2 uv = awayFromEdges(found.u, found.v);
        hit.position = triangle.v0 + uv.x * triangle.e1 + uv.y * triangle.e2;
        hit.e1 = triangle.e1;
        hit.e2 = triangle.e2;
        hit.normalE1 = triangle.n1 - triangle.n0;
        hit.normalE2 = triangle.n2 - triangle.n0;
        hit.normal = triangle.n0 + uv.x * hit.normalE1 + uv.y * hit.normalE2;
    }
    hit.distance = found.t;
    hit.triangle = found.triangle;
    int part = partOf(found.triangle);
    ivec2 place = ivec2(9 * (part & 127), part >> 7);
    uvec4 kind = texelFetch(surfaces, place, 0);
    uvec4 a = texelFetch(surfaces, place + ivec2(1, 0), 0);
    uvec4 b = texelFetch(surfaces, place + ivec2(2, 0), 0);
    hit.kind = int(kind.x);
    hit.inside = kind.y;
    hit.outside = kind.z;
    hit.eta = vec3(uintBitsToFloat(a.x), uintBitsToFloat(a.y), uintBitsToFloat(a.z));
    hit.tint = hit.eta;
    hit.k = vec3(uintBitsToFloat(b.x), uintBitsToFloat(b.y), uintBitsToFloat(b.z));
    return hit;
}

// A ray that leaves a triangle or sphere, off its edges.
vec3 nudged(Branch ray) {
    if (ray.skip >= kFirstSphere) return mix(ray.origin, spheres[2 * (ray.skip - kFirstSphere)].xyz, kEdge);
    BvhSurface own = bvhSurface(ray.skip);
    return nudgedOrigin(ray.origin, ray.direction, own.v0, own.e1, own.e2);
}

Medium mediumAt(int number) {
    Medium medium = vacuum();
    if (number != kVacuum) {
        vec4 figures = media[number];
        medium.eta = figures.x;
        medium.sigmaA = vec3(figures.y, figures.z, figures.w);
#ifdef DISPERSION
        if (wavelength > 0.0) medium.eta = indexAt(medium.eta, dispersionOf(number), wavelength);
#endif
    }
    return medium;
}

vec3 radianceOf(Deposit deposit) {
    vec3 d = environmentFromWorld * deposit.direction;
    LookUps l = lookUpsOver(environmentFromWorld * deposit.directionX, environmentFromWorld * deposit.directionY,
                            kTexelsPerRadian * float(environmentFaceSize), lookUpsWorth(heaviness(deposit.throughput), kMostLookUps));
    vec3 sum = vec3(0.0);
    for (int j = 0; j < l.down; j++)
        for (int i = 0; i < l.across; i++)
            sum += environmentRadiance(d + l.first + float(i) * l.stepX + float(j) * l.stepY, min(l.level, 4.0));
    return deposit.throughput * sum / float(l.across * l.down);
}

// Through the middle of a part of that pixel, and as wide.
Branch cameraRay(ivec2 pixel, PixelPart part) {
    vec3 d = rayCorner + (float(pixel.x) + part.middle.x) * rayPerColumn + (float(pixel.y) + 1.0 - part.middle.y) * rayPerRow;
    Branch ray;
    ray.origin = eye;
    ray.direction = normalize(d);
    ray.throughput = vec3(1.0);
    ray.footprint = cameraFootprint(d, part.size.x * rayPerColumn, part.size.y * rayPerRow);
    ray.media = eyeMedia;
    ray.skip = -1;
    ray.depth = 0;
#ifdef GROUND
    if (groundUse == kGathered) ray = groundRay(ray, (vec2(pixel) + part.middle) / vec2(windowSize));
#endif
    return ray;
}

void main() {
    TransportSettings settings;
    settings.fidelity = FIDELITY;
    settings.fresnel = FRESNEL;
    settings.rayBudget = rayBudget;
    settings.maxDepth = maxDepth;
    settings.weightCutoff = weightCutoff;
    settings.splitGain = 0.0;  // every branch in full: no noise

    ivec2 pixel = ivec2(gl_FragCoord.xy);
    ivec2 place = topLeft + ivec2(pixel.x, windowSize.y - 1 - pixel.y);
    uint seed = pixelSeed(uint(place.y * pictureWidth + place.x), pictureSeed);
    PixelPart part = pixelPart(seed, frame, footprintScale);
    if (centred) part = PixelPart(vec2(0.5), vec2(footprintScale));
#ifdef DISPERSION
    wavelength = 0.0;
#endif
    uint pixelsSeed = seed, index = frame;  // of what the samples of a pixel share
    seed = sampleSeed(seed, frame);

    Tree tree = startTree(cameraRay(pixel, part), seed, 0u);
    int finer = 0;  // samples of the kFinerSamples that take the place of this one, if it grazes
    float weight = 1.0;
    Rounding rounding = exactSoFar();
    vec4 radiance = vec4(0.0, 0.0, 0.0, 1.0);
    vec4 happened = vec4(0.0);
    bool direct = true;  // the camera sees it, through nothing but what was drawn before
#ifdef GROUND
    Branch standing = tree.branch;  // on the ground, of the throughput of its irradiance
    bool shadow = false;            // what is asked for is how much is seen of what is behind
    if (groundUse == kGathered) radiance.a = 0.0;
#endif
#ifdef FINISHES
    vec4 drawn = eyeMedia == 0u ? texelFetch(raster, pixel, 0) : vec4(0.0);
#ifdef GROUND
    if (groundUse == kGathered) drawn = vec4(0.0);
#endif
    if (drawn.a >= 1.0) tree.alive = false;
#endif
    while (true) {
        if (!tree.alive) {
            happened += vec4(float(tree.rays), float(tree.leaks), float(tree.inconsistencies), float(tree.truncated));
            if (weight == 1.0 || finer == kFinerSamples) break;
            PixelPart finerPart = PixelPart(part.middle + part.size * finerSample(seed, uint(finer)), kFinerWidth * part.size);
            tree = startTree(cameraRay(pixel, finerPart), seed, uint(finer));
#ifdef DISPERSION
            wavelength = 0.0;
#endif
            pixelsSeed = seed;
            index = uint(finer);
            finer++;
            rounding = exactSoFar();
            direct = true;
        }
        Deposits deposits = noDeposits();
#ifdef GROUND
        bool grounded = false;
#endif
        if (spent(tree, settings)) {
            deposits = cutBranch(tree);
            rounding = exactSoFar();
#ifdef GROUND
            if (tree.branch.skip < -1) deposits.count = 0;
#endif
        } else {
            tree.rays++;
            bool rasterised = firstHitsKnown && tree.rays == 1 && finer == 0;
            int known = rasterised ? texelFetch(firstHits, pixel, 0).x : kUnknown;
            BvhHit found = nearestHit(tree.branch, rounding.beyond, known);
            bool any = found.triangle >= 0;
#ifdef GROUND
            if (tree.branch.skip == kAsking) {
                if (any) {
                    if (shadow) radiance.a += weight * dot(tree.branch.throughput, vec3(1.0 / 3.0));
                    if (!shadow || groundUse == kGathered) radiance.rgb -= weight * tree.branch.throughput;
                }
                shadow = false;
                uint own = mixedBits(pixelsSeed ^ uint(tree.rays) * 0x9e3779b9u);
                tree.branch = catchingRay(standing, pixelSample(own, owenScrambled(index, mixedBits(own))));
                continue;
            }
            float toGround = groundDistance(tree.branch);
            bool gathers = groundUse == kGathered && tree.branch.depth == 0;
            grounded = toGround > 0.0 && (!any || toGround < found.t || gathers);
            if (grounded) {
                standing = tree.branch;
                standing.footprint = footprintAtSurface(standing.footprint, standing.direction, toGround, vec3(0.0, 1.0, 0.0));
                standing.origin += toGround * standing.direction;
                standing.depth++;
                addDeposit(deposits, depositOf(standing));
                rounding = exactSoFar();
            } else {
#endif
            SurfaceHit hit = surfaceHit(found, tree.branch);
            Encounter met = encounter(tree.branch, hit);
            bool agrees = any ? met.consistent : tree.branch.media == 0u;
#ifdef FINISHES
            int part = partOf(found.triangle);
            uint kind = texelFetch(surfaces, ivec2(9 * (part & 127), part >> 7), 0).w;
            bool finished = any && (kind & kFinished) != 0u;
            agrees = agrees || finished;  // sheets have two sides
#endif
            float nearness = nearnessToEdge(found.u, found.v, tree.branch.direction, met.face.ng);
            if (triesAgain(rounding, tree.branch, any, found.t, nearness, agrees)) {
                if (rounding.nudged) tree.branch.origin = nudged(tree.branch);
                continue;
            }
            rounding = exactSoFar();
#ifdef DISPERSION
            if (any && hit.kind == kDielectric && wavelength == 0.0 && dispersionOf(met.from) + dispersionOf(met.to) > 0.0) {
                float place = spectrumSample(pixelsSeed, index) * 64.0;
                int spectrumPart = int(place);
                vec4 chosen = mix(spectrum[spectrumPart], spectrum[spectrumPart + 1], place - float(spectrumPart));
                wavelength = chosen.x;
                filterTree(tree, chosen.yzw);
            }
#endif
#ifdef FINISHES
            if (finished) {
                Branch at = tree.branch;
                at.throughput *= transmittance(mediumAt(met.from).sigmaA, hit.distance);
                at.footprint = footprintAtSurface(at.footprint, at.direction, hit.distance, met.face.ng);
                at.origin = hit.position;
                at.skip = hit.triangle;
                FinishLook look = finishLook(kind, part, found, hit, met, at);
                if (direct && eyeMedia == 0u && (kind & (kMasked | kBlended)) != 0u) look.alpha = 0.0;
                radiance.rgb += weight * at.throughput * look.alpha * look.L;
                at.throughput *= 1.0 - look.alpha;
                tree.branch = at;
                if (heaviness(at.throughput) <= settings.weightCutoff) endBranch(tree);
                continue;
            }
#endif
            bool again = splitGrazing && weight == 1.0 && any && tree.branch.depth == 0 && tree.branch.skip < 0 &&
                         grazes(tree.branch.footprint, tree.branch.direction, hit, met.face);
            direct = direct && !any;
            if (again) {
                endBranch(tree);
                weight = 1.0 / float(kFinerSamples);
            } else if (any) {
                deposits = scatter(tree, hit, met, mediumAt(met.from), mediumAt(met.to), settings);
            } else {
                bool nothing = tree.branch.depth == 0 && direct && !background;
#ifdef GROUND
                bool counted = tree.branch.skip == kCatching;
#endif
                deposits = escape(tree);
#ifdef GROUND
                if (counted) deposits.count = 0;
#endif
                if (nothing) {
                    radiance.a -= weight;
                    deposits.count = 0;
                }
            }
#ifdef GROUND
            }
#endif
        }
        vec3 found = vec3(0.0);
        if (deposits.count > 0) found += radianceOf(deposits.first);
        if (deposits.count > 1) found += radianceOf(deposits.second);
#ifdef GROUND
        if (grounded) {
            vec3 E = max(groundIrradiance, vec3(1e-20));
            bool seen = standing.depth == 1 && direct;  // by the camera
            if (seen && groundUse == kGathered) found = vec3(1.0);
            // No ground that is not the background itself reflects more than it gets.
            standing.throughput = (seen ? found : min(found, standing.throughput * E / kPi)) / E;
            tree.branch = standing;
            bool nothing = seen && !background && groundUse != kGathered;
            if (nothing) {
                radiance.a -= weight;
                found = vec3(0.0);
            }
            direct = false;
            if (groundUse == kKnown) {
                vec4 light = textureLod(groundLight, groundTexel(standing.origin), groundLevel);
                if (nothing) radiance.a += weight * light.a;
                found += standing.throughput * E * (light.rgb - (nothing ? 1.0 - light.a : 1.0));
                endBranch(tree);
            } else if (!seen && heaviness(found) < weightCutoff) {
                endBranch(tree);
            } else {
                shadow = nothing || groundUse == kGathered && standing.depth == 1;
                if (nothing) tree.branch.throughput = 1.0 / E;
                uint own = mixedBits(pixelsSeed ^ uint(tree.rays) * 0x85ebca6bu);
                tree.branch = askingRay(tree.branch, index ^ own >> 20u);
            }
        }
#endif
        radiance.rgb += weight * found;
    }

#ifdef FINISHES
    radiance = drawn + max(1.0 - drawn.a, 0.0) * radiance;
#endif
    vec4 before = first ? vec4(0.0) : texelFetch(sum, pixel, 0);
    fragmentColor = before + radiance;
#ifdef GROUND
    if (groundUse == kGathered) fragmentColor = mix(before, radiance, 1.0 / float(frame + 1u));
#endif
#if COUNTING == 1
    counts = first ? happened : texelFetch(counted, pixel, 0) + happened;
#endif
}
