#version 300 es
// Fidelity `double` and `exact`: the light-path tree of one camera ray a pixel, traced through the
// triangles of the scene. The host of tukor/transport/path_tree.h in GLSL.
//
// FIDELITY and FRESNEL are those of the transport: compilers leave out the rest. COUNTING: 1 adds a second output with what
// happened on the way.
#include "tukor/gl/shaders/environment.glsl"
#include "tukor/geometry/bvh_traversal.h"
#include "tukor/transport/path_tree.h"

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
uniform usampler2D surfaces;  // three texels a part, see traced_scene.cpp

uniform int rayBudget;
uniform int maxDepth;
uniform float weightCutoff;
uniform uint frame;

uniform sampler2D sum;  // of the frames before
uniform bool first;     // there are none
layout(location = 0) out vec4 fragmentColor;
#if COUNTING == 1
uniform sampler2D counted;
layout(location = 1) out vec4 counts;  // rays, leaks, inconsistencies, truncated
#endif

SurfaceHit surfaceHit(BvhHit found) {
    BvhSurface triangle = bvhSurface(found.triangle);
    SurfaceHit hit;
    hit.distance = found.t;
    hit.position = triangle.v0 + found.u * triangle.e1 + found.v * triangle.e2;
    hit.e1 = triangle.e1;
    hit.e2 = triangle.e2;
    hit.normalE1 = triangle.n1 - triangle.n0;
    hit.normalE2 = triangle.n2 - triangle.n0;
    hit.normal = triangle.n0 + found.u * hit.normalE1 + found.v * hit.normalE2;
    hit.triangle = found.triangle;
    ivec2 place = ivec2(3 * (triangle.part & 255), triangle.part >> 8);
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

Medium mediumAt(int number) {
    Medium medium = vacuum();
    if (number != kVacuum) {
        vec4 figures = media[number];
        medium.eta = figures.x;
        medium.sigmaA = vec3(figures.y, figures.z, figures.w);
    }
    return medium;
}

vec3 radianceOf(Deposit deposit) {
    float level = footprintLevel(deposit.solidAngle, environmentFaceSize);
    return deposit.throughput * environmentRadiance(environmentFromWorld * deposit.direction, level);
}

// Neighbouring pixels and frames get unrelated numbers. [Jarzynski and Olano 2020, pcg]
uint seedOf(uvec2 pixel) {
    uint state = (pixel.x + 7919u * (pixel.y + 7919u * frame)) * 747796405u + 2891336453u;
    uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return (word >> 22u) ^ word;
}

void main() {
    TransportSettings settings;
    settings.fidelity = FIDELITY;
    settings.fresnel = FRESNEL;
    settings.rayBudget = rayBudget;
    settings.maxDepth = maxDepth;
    settings.weightCutoff = weightCutoff;
    settings.splitWeight = 0.0;  // every branch in full: no noise

    vec3 d = rayCorner + gl_FragCoord.x * rayPerColumn + gl_FragCoord.y * rayPerRow;
    Branch ray;
    ray.origin = eye;
    ray.direction = normalize(d);
    ray.throughput = vec3(1.0);
    ray.footprint = cameraFootprint(d, footprintScale * rayPerColumn, footprintScale * rayPerRow);
    ray.media = eyeMedia;
    ray.skip = -1;
    ray.depth = 0;

    Tree tree = startTree(ray, seedOf(uvec2(gl_FragCoord.xy)));
    vec4 radiance = vec4(0.0, 0.0, 0.0, 1.0);
    while (tree.alive) {
        Deposits deposits;
        if (spent(tree, settings)) {
            deposits = cutBranch(tree);
        } else {
            tree.rays++;
            BvhHit found = nearestBvhHit(tree.branch.origin, tree.branch.direction, 1e30, tree.branch.skip);
            if (found.triangle >= 0) {
                SurfaceHit hit = surfaceHit(found);
                Encounter met = encounter(tree.branch, hit);
                deposits = scatter(tree, hit, met, mediumAt(met.from), mediumAt(met.to), settings);
            } else {
                bool nothing = tree.branch.depth == 0 && tree.branch.skip < 0 && !background;
                deposits = escape(tree);
                if (nothing) {
                    radiance.a = 0.0;
                    deposits.count = 0;
                }
            }
        }
        if (deposits.count > 0) radiance.rgb += radianceOf(deposits.first);
        if (deposits.count > 1) radiance.rgb += radianceOf(deposits.second);
    }

    ivec2 pixel = ivec2(gl_FragCoord.xy);
    fragmentColor = first ? radiance : texelFetch(sum, pixel, 0) + radiance;
#if COUNTING == 1
    vec4 happened = vec4(float(tree.rays), float(tree.leaks), float(tree.inconsistencies), float(tree.truncated));
    counts = first ? happened : texelFetch(counted, pixel, 0) + happened;
#endif
}
