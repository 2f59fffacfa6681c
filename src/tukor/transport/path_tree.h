// What light does after it met the first surface: the tree of reflections and refractions, one
// event at a time. Shared source, and a state machine: the host owns the loop.
//
//     Tree tree = startTree(cameraRay, seed, index);
//     while (tree.alive) {
//         if (spent(tree, settings)) {
//             deposits = cutBranch(tree);
//         } else {
//             tree.rays++;
//             // the nearest triangle but tree.branch.skip along tree.branch, at t > 0
//             if (none) {
//                 deposits = escape(tree);
//             } else {
//                 Encounter met = encounter(tree.branch, hit);
//                 deposits = scatter(tree, hit, met, medium(met.from), medium(met.to), settings);
//             }
//         }
//         L += throughput * environment radiance of each of the deposits
//     }
//
// So the host supplies the nearest hit, the table of media and the environment; nothing is lost:
// every branch that is dropped for any reason becomes one look-up along its own direction, and the
// throughputs of all deposits of a lossless scene sum to 1.
//
// Radiance is carried as L / eta^2, which no interface changes: inside of glass, a picture shows
// what it would show if the light had been measured outside.
#pragma once
#include "tukor/optics/absorption.h"
#include "tukor/optics/directions.h"
#include "tukor/transport/branch.h"
#include "tukor/transport/rounding.h"
#include "tukor/transport/scattering.h"

TUKOR_SHARED_BEGIN(transport)
TUKOR_SHARED_USING(optics)

/// Values of TransportSettings::fidelity, those of Fidelity.
TUKOR_CONST int kFidelitySingle = 0;
TUKOR_CONST int kFidelityTwo = 1;
TUKOR_CONST int kFidelityExact = 2;

struct TransportSettings {
    int fidelity;
    int fresnel;
    int rayBudget;       // rays that one tree may trace
    int maxDepth;        // events along one branch
    float weightCutoff;  // branches lighter than this become a look-up
    float splitGain;     // see followsBoth(); 0: always both
};

/// The first rays of a tree are its heaviest, and of simple shapes all that matter: there both
/// children are followed for a smaller gain, too.
TUKOR_CONST int kFirstRays = 10;
TUKOR_CONST float kLeastGain = 1e-6f;

/// Whether both children of a branch of that `weight` are worth their rays, of which the first is
/// reflected, with the share R. Otherwise one is chosen by chance, with its share as the
/// probability and unchanged weight. The variance that adds is weight^2 R T times the squared
/// difference of what the two show; the rays that saves are those of the other, which chance
/// would follow with the probability of its share: the gain of a ray is weight^2 min(R, T).
TUKOR_FN bool followsBoth(float weight, float R, int rays, float splitGain) {
    float least = rays < kFirstRays ? min(splitGain, kLeastGain) : splitGain;
    return weight * weight * min(R, 1.0f - R) >= least;
}

/// A surface in the sense of the ray, and the media on both sides of it.
struct Encounter {
    Facing face;
    int from;     // medium on the ray's side, kVacuum or its number
    int to;       // beyond; the same at opaque surfaces
    uint beyond;  // media set beyond the surface
    bool consistent;
};

/// Which media meet at a surface that a ray inside of `media` sees as `face`.
TUKOR_FN Encounter encounterAt(Facing face, uint media, SurfaceHit hit) {
    Encounter met;
    met.face = face;
    met.from = mediumOf(media);
    met.beyond = media;
    met.consistent = face.front;
    if (hit.kind == kDielectric) {
        uint entered = face.front ? hit.inside : hit.outside;
        uint left = face.front ? hit.outside : hit.inside;
        met.beyond = (media & ~left) | entered;
        met.consistent = (media & entered) == 0u && (media & left) == left;
    }
    met.to = mediumOf(met.beyond);
    return met;
}

/// The same where `branch` hit it.
TUKOR_FN Encounter encounter(Branch branch, SurfaceHit hit) {
    return encounterAt(facingSurface(hit, branch.direction), branch.media, hit);
}

/// Begins a step, with the next branch where one has ended. Whether that branch may not go on.
TUKOR_FN bool spent(TUKOR_INOUT(Tree) tree, TransportSettings settings) {
    if (tree.ended) nextBranch(tree);
    return tree.rays >= settings.rayBudget || tree.branch.depth >= settings.maxDepth;
}

/// Ends the current branch before its time, in a look-up.
TUKOR_FN Deposits cutBranch(TUKOR_INOUT(Tree) tree) {
    Deposits deposits = noDeposits();
    addDeposit(deposits, depositOf(tree.branch));
    tree.truncated = tree.truncated + 1;
    endBranch(tree);
    return deposits;
}

/// The current branch has met nothing: it sees the environment.
TUKOR_FN Deposits escape(TUKOR_INOUT(Tree) tree) {
    Deposits deposits = noDeposits();
    addDeposit(deposits, depositOf(tree.branch));
    if (tree.branch.media != 0u) tree.leaks = tree.leaks + 1;
    endBranch(tree);
    return deposits;
}

/// Lecture rows 13 and 14, each on its side of the facet.
TUKOR_FN Branch reflectedBranch(Branch at, NormalChange change, Encounter met, Scattering s) {
    Branch branch = at;
    branch.footprint = reflectedFootprint(at.footprint, change, met.face, at.direction);
    branch.direction = onSide(reflectDirection(at.direction, met.face.n), met.face.ng, 1.0f);
    branch.origin = leavingFrom(at.origin, branch.direction);
    branch.throughput = at.throughput * s.R;
    return branch;
}

TUKOR_FN Branch refractedBranch(Branch at, NormalChange change, Encounter met, Scattering s) {
    Branch branch = at;
    Refraction refraction = refractDirection(at.direction, met.face.n, s.eta);
    branch.footprint = refractedFootprint(at.footprint, change, met.face, at.direction, s.eta,
                                          refraction.cosThetaT);
    branch.direction = onSide(refraction.direction, met.face.ng, -1.0f);
    branch.origin = leavingFrom(at.origin, branch.direction);
    branch.throughput = at.throughput * s.T;
    branch.media = met.beyond;
    return branch;
}

/// The levels below exact: look-ups at the first surface (lecture rows 10 and 11), or reflection at
/// the first and refraction, whole, at the second. `at` lies on the surface. What is totally
/// reflected there leaves somewhere else, so it is looked up widely about its direction.
TUKOR_FN Deposits scatterOnLadder(TUKOR_INOUT(Tree) tree, Branch at, NormalChange change, int kind,
                                  Encounter met, Scattering s, int fidelity) {
    Deposits deposits = noDeposits();
    bool first = at.depth == 1;
    if (!first && s.T > 0.0f) {
        s.T = 1.0f;
    } else if (!first && kind == kDielectric) {
        s.R = vec3(1.0f);
    }
    if (first || s.T <= 0.0f) {
        Branch reflected = reflectedBranch(at, change, met, s);
        if (!first && kind == kDielectric) reflected.footprint = wideFootprint(reflected.direction);
        addDeposit(deposits, depositOf(reflected));
    }
    if (s.T > 0.0f) {
        Branch refracted = refractedBranch(at, change, met, s);
        if (first && fidelity == kFidelityTwo) {
            tree.branch = refracted;
            return deposits;
        }
        addDeposit(deposits, depositOf(refracted));
    }
    endBranch(tree);
    return deposits;
}

/// Follows the heavier of two branches and keeps the lighter.
TUKOR_FN Deposits splitBranch(TUKOR_INOUT(Tree) tree, Branch a, Branch b, float weightCutoff) {
    Deposits deposits = noDeposits();
    bool swap = heaviness(b.throughput) > heaviness(a.throughput);
    Branch heavier = a;
    Branch lighter = b;
    if (swap) {
        heavier = b;
        lighter = a;
    }
    float weight = heaviness(lighter.throughput);
    if (weight >= weightCutoff) {
        keepBranch(tree, deposits, lighter);
    } else if (weight > 0.0f) {
        tree.truncated = tree.truncated + 1;
        addDeposit(deposits, depositOf(lighter));
    }
    tree.branch = heavier;
    return deposits;
}

/// The ways on from a surface.
TUKOR_CONST int kReflects = 0;
TUKOR_CONST int kRefracts = 1;
TUKOR_CONST int kSplits = 2;

/// Which of them light goes; where chance decides, that way gets all of it in `s`. `weight`: the
/// heaviness of what arrives.
TUKOR_FN int wayOn(TUKOR_INOUT(Tree) tree, TUKOR_INOUT(Scattering) s, float weight,
                   float splitGain) {
    if (s.T <= 0.0f) return kReflects;
    if (followsBoth(weight, s.R.x, tree.rays, splitGain)) return kSplits;
    bool reflects = nextRandom(tree) < s.R.x;
    s.R = vec3(1.0f);
    s.T = 1.0f;
    return reflects ? kReflects : kRefracts;
}

/// A branch that carries too little to be followed becomes a look-up.
TUKOR_PROCEDURE endIfLight(TUKOR_INOUT(Tree) tree, TUKOR_INOUT(Deposits) deposits,
                           float weightCutoff) {
    float weight = heaviness(tree.branch.throughput);
    if (weight < weightCutoff || !(weight > 0.0f)) {
        if (weight > 0.0f) {
            addDeposit(deposits, depositOf(tree.branch));
            tree.truncated = tree.truncated + 1;
        }
        endBranch(tree);
    }
}

/// The current branch has met a surface; `from` and `to` are the media that `met` names.
TUKOR_FN Deposits scatter(TUKOR_INOUT(Tree) tree, SurfaceHit hit, Encounter met, Medium from,
                          Medium to, TransportSettings settings) {
    if (!met.consistent) tree.inconsistencies = tree.inconsistencies + 1;
    Branch at = tree.branch;
    at.throughput = at.throughput * transmittance(from.sigmaA, hit.distance);
    at.footprint = footprintAtSurface(at.footprint, at.direction, hit.distance, met.face.ng);
    at.origin = hit.position;
    at.skip = hit.triangle;
    if (hit.kind == kDielectric && from.eta == to.eta) {  // nothing to be seen: straight on
        at.media = met.beyond;
        at.origin = leavingFrom(hit.position, at.direction);
        tree.branch = at;
        return noDeposits();
    }
    at.depth = at.depth + 1;

    Scattering s;
    if (hit.kind == kDielectric) {
        s = clearScattering(met.face, to.eta / from.eta, settings.fresnel);
    } else {
        s = opaqueScattering(hit, met.face, from.eta, settings.fresnel);
    }
    NormalChange change = normalChangeOver(at.footprint, hit, met.face);
    if (settings.fidelity != kFidelityExact) {
        return scatterOnLadder(tree, at, change, hit.kind, met, s, settings.fidelity);
    }

    Deposits deposits = noDeposits();
    int way = wayOn(tree, s, heaviness(at.throughput), settings.splitGain);
    if (way == kReflects) {
        tree.branch = reflectedBranch(at, change, met, s);
    } else if (way == kRefracts) {
        tree.branch = refractedBranch(at, change, met, s);
    } else {
        deposits = splitBranch(tree, refractedBranch(at, change, met, s),
                               reflectedBranch(at, change, met, s), settings.weightCutoff);
    }
    endIfLight(tree, deposits, settings.weightCutoff);
    return deposits;
}

TUKOR_SHARED_END
