#include "tukor/trace/event_lanes.h"

#include <cstring>
#include <random>

#include <gtest/gtest.h>

#include "tukor/transport/grazing.h"

namespace tukor::trace {
namespace {

using transport::Branch, transport::Deposit, transport::Deposits, transport::Medium,
    transport::SurfaceHit, transport::Tree;

class Chance {
public:
    float within(float least, float most) {
        return std::uniform_real_distribution<float>(least, most)(engine_);
    }
    bool one(int in) { return std::uniform_int_distribution<int>(1, in)(engine_) == 1; }
    glm::vec3 vector(float most) {
        return {within(-most, most), within(-most, most), within(-most, most)};
    }
    glm::vec3 direction() {
        for (;;) {
            const glm::vec3 v = vector(1.0f);
            if (dot(v, v) > 1e-3f && dot(v, v) <= 1.0f) return glm::normalize(v);
        }
    }

private:
    std::mt19937 engine_{1};
};

/// A branch anywhere, at the last surface of some others.
Tree anyTree(Chance& chance) {
    Branch branch{};
    branch.origin = chance.vector(2.0f);
    branch.direction = chance.direction();
    branch.throughput = glm::abs(chance.vector(1.0f));
    branch.footprint = {chance.vector(0.01f), chance.vector(0.01f), chance.vector(0.01f),
                        chance.vector(0.01f)};
    branch.skip = 3;
    Tree tree = transport::startTree(branch, 7u, 5u);
    tree.rays = chance.one(2) ? 2 : 40;
    return tree;
}

/// Also grazing, without area, and with normals that are turned away.
SurfaceHit anyHit(Chance& chance, glm::vec3 direction) {
    SurfaceHit hit{};
    hit.distance = chance.within(0.01f, 3.0f);
    hit.position = chance.vector(2.0f);
    const float size = chance.one(20) ? 1e-9f : 0.1f;
    hit.e1 = chance.vector(size);
    hit.e2 = chance.one(50) ? hit.e1 : chance.vector(size);
    if (chance.one(10)) hit.e1 = 0.1f * direction + 1e-6f * hit.e1;
    hit.normal = chance.one(50) ? glm::vec3(0.0f)
                 : chance.one(3)
                     ? chance.direction()
                     : glm::cross(hit.e1, hit.e2) + 0.1f * size * size * chance.direction();
    hit.normalE1 = chance.vector(0.3f);
    hit.normalE2 = chance.vector(0.3f);
    hit.triangle = 11;
    hit.kind = chance.one(6)   ? transport::kMirror
               : chance.one(6) ? transport::kMetal
                               : transport::kDielectric;
    hit.tint = {1.0f, 0.8f, 0.3f};
    hit.eta = {0.2f, 0.4f, 1.3f};
    hit.k = {3.9f, 2.4f, 1.8f};
    hit.inside = 1u;
    return hit;
}

template <class T>
bool same(const T& a, const T& b) {  // NaN included
    return std::memcmp(&a, &b, sizeof a) == 0;
}

bool same(const Deposits& a, const Deposits& b) {
    const auto one = [](const Deposit& x, const Deposit& y) {
        return same(x.throughput, y.throughput) && same(x.direction, y.direction) &&
               same(x.solidAngle, y.solidAngle) && same(x.directionX, y.directionX) &&
               same(x.directionY, y.directionY);
    };
    return a.count == b.count && (a.count < 1 || one(a.first, b.first)) &&
           (a.count < 2 || one(a.second, b.second));
}

TEST(EventLanes, DoToTheBitWhatTheSharedSourceDoes) {
    Chance chance;
    transport::TransportSettings settings{};
    settings.fidelity = transport::kFidelityExact;
    settings.weightCutoff = 1e-3f;
    settings.splitGain = 1e-2f;
    int refracted = 0, grazing = 0;
    for (int round = 0; round < 4000; ++round) {
        settings.fresnel = chance.one(4) ? transport::kFresnelSchlick : transport::kFresnelExact;
        const Medium air = transport::vacuum();
        const Medium glass{chance.one(8) ? 1.0f : chance.within(1.1f, 2.5f), glm::vec3(0.2f)};
        EventLanes lanes;
        std::array<Tree, kPacketWidth> trees;
        std::array<SurfaceHit, kPacketWidth> hits;
        for (int i = 0; i < kPacketWidth; ++i) {
            const auto n = static_cast<std::size_t>(i);
            trees[n] = anyTree(chance);
            hits[n] = anyHit(chance, trees[n].branch.direction);
            lanes.put(i, trees[n].branch, hits[n]);
        }
        lanes.face();
        for (int i = 0; i < kPacketWidth; ++i) {
            const auto n = static_cast<std::size_t>(i);
            trees[n].branch.media = lanes.side[i] > 0.0f ? 0u : 1u;
            lanes.eta[i] = hits[n].kind != transport::kDielectric ? 1.0f
                           : lanes.side[i] > 0.0f                 ? glass.eta
                                                                  : 1.0f / glass.eta;
        }
        lanes.bend(true, settings.fresnel);
        for (int i = 0; i < kPacketWidth; ++i) {
            const auto n = static_cast<std::size_t>(i);
            Tree alone = trees[n], together = trees[n];
            const SurfaceHit& hit = hits[n];
            const transport::Encounter met = transport::encounter(alone.branch, hit);
            const Medium& from = met.from < 0 ? air : glass;
            const Medium& to = met.to < 0 ? air : glass;
            const bool grazes =
                transport::grazes(alone.branch.footprint, alone.branch.direction, hit, met.face);
            if (hit.kind == transport::kDielectric) {
                ASSERT_EQ(lanes.bendsAway[i] != 0, grazes);
            }
            const Deposits expected = transport::scatter(alone, hit, met, from, to, settings);
            const transport::Encounter found =
                transport::encounterAt(lanes.facing(i), together.branch.media, hit);
            const Deposits deposits = lanes.scatter(i, together, hit, found, from, to, settings);
            ASSERT_TRUE(same(deposits, expected)) << "round " << round << ", lane " << i;
            ASSERT_TRUE(same(together.branch, alone.branch)) << "round " << round << ", lane " << i;
            ASSERT_EQ(together.pendingCount, alone.pendingCount);
            if (alone.pendingCount > 0) {
                ASSERT_TRUE(same(together.pending[0], alone.pending[0]));
            }
            ASSERT_EQ(together.ended, alone.ended);
            ASSERT_EQ(together.truncated, alone.truncated);
            ASSERT_EQ(together.inconsistencies, alone.inconsistencies);
            refracted += alone.branch.media != trees[n].branch.media;
            grazing += grazes;
        }
    }
    EXPECT_GT(refracted, 1000);
    EXPECT_GT(grazing, 100);
}

TEST(EventLanes, ReflectTheSameWithoutClearSurfaces) {
    Chance chance;
    EventLanes lanes;
    for (int i = 0; i < kPacketWidth; ++i) {
        const Tree tree = anyTree(chance);
        lanes.put(i, tree.branch, anyHit(chance, tree.branch.direction));
        lanes.eta[i] = 1.0f;
    }
    lanes.face();
    lanes.bend(true, transport::kFresnelExact);
    const EventLanes::Way all = lanes.reflected;
    lanes.reflected = {};
    lanes.bend(false, transport::kFresnelExact);
    EXPECT_TRUE(same(lanes.reflected, all));
}

}  // namespace
}  // namespace tukor::trace
