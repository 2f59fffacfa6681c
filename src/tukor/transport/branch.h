// One branch of a light path, and the queue of those that wait. Shared source.
#pragma once
#include "tukor/transport/footprint.h"
#include "tukor/transport/media.h"
#include "tukor/transport/sampler.h"

TUKOR_SHARED_BEGIN(transport)

/// A ray on its way, with all that it needs to go on later.
struct Branch {
    vec3 origin;
    vec3 direction;   // unit
    vec3 throughput;  // what its radiance counts in the pixel
    Footprint footprint;
    uint media;  // the dielectrics that contain it, see media.h
    int skip;    // the triangle that it leaves; -1 for a camera ray
    int depth;   // reflections and refractions so far
};

/// A look-up in the environment that the host owes to the picture: throughput * radiance.
struct Deposit {
    vec3 throughput;
    vec3 direction;    // unit
    float solidAngle;  // of the footprint, sr
    vec3 directionX;   // change of `direction` over the footprint's width
    vec3 directionY;   // and height
};

/// Up to two look-ups, the most that one event asks for.
struct Deposits {
    int count;
    Deposit first;
    Deposit second;
};

TUKOR_FN float heaviness(vec3 throughput) {
    return max(throughput.x, max(throughput.y, throughput.z));
}

TUKOR_FN Deposit depositOf(Branch branch) {
    Deposit d;
    d.throughput = branch.throughput;
    d.direction = branch.direction;
    d.solidAngle = footprintSolidAngle(branch.footprint);
    d.directionX = branch.footprint.directionX;
    d.directionY = branch.footprint.directionY;
    return d;
}

TUKOR_FN Deposits noDeposits() {
    Deposits all;
    all.count = 0;
    all.first.throughput = vec3(0.0f);
    all.first.direction = vec3(0.0f);
    all.first.solidAngle = 0.0f;
    all.first.directionX = vec3(0.0f);
    all.first.directionY = vec3(0.0f);
    all.second = all.first;
    return all;
}

/// Appends; there is room for two.
TUKOR_PROCEDURE addDeposit(TUKOR_INOUT(Deposits) all, Deposit one) {
    if (all.count == 0) {
        all.first = one;
    } else {
        all.second = one;
    }
    all.count = all.count + 1;
}

/// How many branches of one tree can wait: more waited never in the pictures that decided it.
TUKOR_CONST int kPendingBranches = 8;

/// The light path of one camera ray: a branch under way and those that wait.
///
/// Start it with startTree; while `alive`, do what path_tree.h says.
struct Tree {
    Branch branch;
    Branch pending[kPendingBranches];
    float pendingWeights[kPendingBranches];  // their heaviness; -1 where there is none
    int pendingCount;
    bool ended;  // the branch: spent() puts the next in its place
    bool alive;
    int rays;   // rays traced so far; the host counts them
    uint seed;  // what chance decides: the same place, `index`, in a sequence each
    uint index;
    uint decisions;       // so far
    int truncated;        // branches that became a look-up by budget, depth, weight or want of room
    int leaks;            // branches that left the scene with a dielectric around them
    int inconsistencies;  // surfaces met from the side on which the path was not
};

/// `branch` is the camera ray: throughput 1, depth 0, skip -1, media as they are around the eye.
/// What chance decides is spread evenly over the trees with the same `seed`, numbered by `index`.
TUKOR_FN Tree startTree(Branch branch, uint seed, uint index) {
    Tree tree;
    tree.branch = branch;
    for (int i = 0; i < kPendingBranches; i++) tree.pendingWeights[i] = -1.0f;
    tree.pendingCount = 0;
    tree.ended = false;
    tree.alive = true;
    tree.rays = 0;
    tree.seed = mixedBits(seed ^ 0x68e31da4u);
    tree.index = index;
    tree.decisions = 0u;
    tree.truncated = 0;
    tree.leaks = 0;
    tree.inconsistencies = 0;
    return tree;
}

/// Uniform in [0, 1): for each decision another shuffled and scrambled sequence. [Burley 2020]
TUKOR_FN float nextRandom(TUKOR_INOUT(Tree) tree) {
    tree.decisions = tree.decisions + 1u;
    uint seed = mixedBits(tree.seed + tree.decisions * 0x9e3779b9u);
    uint place = owenScrambled(tree.index, seed);
    return float(owenScrambledReverse(place, mixedBits(seed)) >> 8u) * (1.0f / 16777216.0f);
}

/// All light of the tree goes through a filter.
TUKOR_PROCEDURE filterTree(TUKOR_INOUT(Tree) tree, vec3 filtered) {
    tree.branch.throughput = tree.branch.throughput * filtered;
    for (int i = 0; i < kPendingBranches; i++) {
        if (tree.pendingWeights[i] >= 0.0f) {
            tree.pending[i].throughput = tree.pending[i].throughput * filtered;
        }
    }
}

/// Ends the current branch, and the tree if no other waits.
TUKOR_PROCEDURE endBranch(TUKOR_INOUT(Tree) tree) {
    tree.ended = true;
    if (tree.pendingCount == 0) tree.alive = false;
}

/// After the end of a branch: the heaviest that waits goes on.
///
/// Called from one place, as keepBranch is, and the loops are of constant length: shader compilers
/// copy functions to wherever they are called, and access to an array by a computed index is dear.
TUKOR_PROCEDURE nextBranch(TUKOR_INOUT(Tree) tree) {
    int pick = 0;
    float most = -1.0f;
    for (int i = 0; i < kPendingBranches; i++) {
        if (tree.pendingWeights[i] > most) {
            most = tree.pendingWeights[i];
            pick = i;
        }
    }
    for (int i = 0; i < kPendingBranches; i++) {
        if (i == pick) {
            tree.branch = tree.pending[i];
            tree.pendingWeights[i] = -1.0f;
        }
    }
    tree.pendingCount = tree.pendingCount - 1;
    tree.ended = false;
}

/// Puts a branch among those that wait. If there is no room, the lightest of all becomes a look-up.
TUKOR_PROCEDURE keepBranch(TUKOR_INOUT(Tree) tree, TUKOR_INOUT(Deposits) deposits, Branch branch) {
    float weight = heaviness(branch.throughput);
    int pick = 0;
    float least = 1e30f;
    for (int i = 0; i < kPendingBranches; i++) {
        if (tree.pendingWeights[i] < least) {
            least = tree.pendingWeights[i];
            pick = i;
        }
    }
    if (least >= 0.0f) {
        tree.truncated = tree.truncated + 1;
        if (least >= weight) {
            addDeposit(deposits, depositOf(branch));
            return;
        }
        Branch evicted = branch;
        for (int i = 0; i < kPendingBranches; i++) {
            if (i == pick) evicted = tree.pending[i];
        }
        addDeposit(deposits, depositOf(evicted));
    } else {
        tree.pendingCount = tree.pendingCount + 1;
    }
    for (int i = 0; i < kPendingBranches; i++) {
        if (i == pick) {
            tree.pending[i] = branch;
            tree.pendingWeights[i] = weight;
        }
    }
}

TUKOR_SHARED_END
