#version 300 es
// The smallest host of the transport: one mirror-like plane under a grey sky. It exists to be compiled: glslangValidator
// proves with it that the shared source is GLSL ES 3.00.
#include "tukor/transport/path_tree.h"

uniform int uFidelity;
uniform vec3 uDirection;
out vec4 oRadiance;

bool nearestHit(Branch ray, out SurfaceHit hit) {
    hit.distance = -ray.origin.y / ray.direction.y;
    hit.position = ray.origin + hit.distance * ray.direction;
    hit.e1 = vec3(0.0, 0.0, 1.0);
    hit.e2 = vec3(1.0, 0.0, 0.0);
    hit.normal = vec3(0.0, 1.0, 0.0);
    hit.normalE1 = vec3(0.0);
    hit.normalE2 = vec3(0.0);
    hit.triangle = 0;
    hit.kind = kDielectric;
    hit.tint = vec3(1.0);
    hit.eta = vec3(1.0);
    hit.k = vec3(0.0);
    hit.inside = 1u;
    hit.outside = 0u;
    return ray.skip != hit.triangle && hit.distance > 0.0;
}

Medium mediumAt(int number) {
    Medium medium = vacuum();
    if (number != kVacuum) medium.eta = 1.5;
    return medium;
}

vec3 environmentRadiance(Deposit deposit) {
    return deposit.throughput * vec3(footprintLevel(deposit.solidAngle, 512));
}

void main() {
    TransportSettings settings;
    settings.fidelity = uFidelity;
    settings.fresnel = kFresnelExact;
    settings.rayBudget = 16;
    settings.maxDepth = 8;
    settings.weightCutoff = 1e-2;
    settings.splitGain = 0.0;

    Branch ray;
    ray.origin = vec3(0.0, 1.0, 0.0);
    ray.direction = normalize(uDirection);
    ray.throughput = vec3(1.0);
    ray.footprint = cameraFootprint(uDirection, dFdx(uDirection), dFdy(uDirection));
    ray.media = 0u;
    ray.skip = -1;
    ray.depth = 0;

    Tree tree = startTree(ray, 1u, 0u);
    vec3 L = vec3(0.0);
    while (tree.alive) {
        Deposits deposits;
        SurfaceHit hit;
        if (spent(tree, settings)) {
            deposits = cutBranch(tree);
        } else {
            tree.rays++;
            if (nearestHit(tree.branch, hit)) {
                Encounter met = encounter(tree.branch, hit);
                deposits = scatter(tree, hit, met, mediumAt(met.from), mediumAt(met.to), settings);
            } else {
                deposits = escape(tree);
            }
        }
        if (deposits.count > 0) L += environmentRadiance(deposits.first);
        if (deposits.count > 1) L += environmentRadiance(deposits.second);
    }
    oRadiance = vec4(L, 1.0);
}
