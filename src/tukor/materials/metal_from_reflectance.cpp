// eta and k from a reflectance at normal incidence. [Gulbrandsen 2014]
#include <algorithm>
#include <cmath>

#include "tukor/materials/materials.h"
#include "tukor/optics/fresnel.h"

namespace tukor {

namespace {

struct Index {
    float eta;
    float k;
};

/// On the circle of all eta + i k with reflectance r at normal incidence. edgeTint 0: the
/// dielectric (1 + sqrt r) / (1 - sqrt r); 1: (1 - r) / (1 + r), the least eta.
Index indexWithReflectance(float r, float edgeTint) {
    const float root = std::sqrt(r);
    const float least = (1.0f - r) / (1.0f + r);
    const float most = (1.0f + root) / (1.0f - root);
    // Upwards of r = 0.996 the largest eta leaves the range of checkMaterial; the circle's radius,
    // k's maximum, does not below 0.998.
    const float eta = std::min(edgeTint * least + (1.0f - edgeTint) * most, 1e3f);
    const float k2 = (r * (eta + 1.0f) * (eta + 1.0f) - (eta - 1.0f) * (eta - 1.0f)) / (1.0f - r);
    return {eta, std::sqrt(std::max(k2, 0.0f))};
}

float distanceToSchlick(float r, float edgeTint) {
    constexpr int kAngles = 48;  // the curves have two bends: finer grids move the minimum by 1e-3
    const Index index = indexWithReflectance(r, edgeTint);
    float worst = 0.0f;
    for (int i = 1; i < kAngles; ++i) {
        const float cosThetaI = static_cast<float>(i) / kAngles;
        const float exact =
            optics::fresnelConductor(cosThetaI, glm::vec3(index.eta), glm::vec3(index.k)).x;
        worst =
            std::max(worst, std::abs(exact - optics::fresnelSchlick(cosThetaI, glm::vec3(r)).x));
    }
    return worst;
}

/// Golden-section search: the distance has one minimum in [0, 1] for every r (tested).
float nearestEdgeTint(float r) {
    constexpr float kGolden = 0.61803399f;
    float low = 0.0f;
    float high = 1.0f;
    for (int i = 0; i < 24; ++i) {  // 0.618^24 = 1e-5 of the interval
        const float a = high - kGolden * (high - low);
        const float b = low + kGolden * (high - low);
        if (distanceToSchlick(r, a) < distanceToSchlick(r, b)) {
            high = b;
        } else {
            low = a;
        }
    }
    return 0.5f * (low + high);
}

/// r = 1 has no finite index, and above 0.998 the least eta is below the range of checkMaterial.
float clamped(float r) {
    return r > 0.0f ? std::min(r, 0.998f) : 0.0f;
}

Material metalFrom(glm::vec3 R0, glm::vec3 edgeTint) {
    Material material;
    material.kind = MaterialKind::metal;
    for (int channel = 0; channel < 3; ++channel) {
        const Index index = indexWithReflectance(clamped(R0[channel]), edgeTint[channel]);
        material.eta[channel] = index.eta;
        material.k[channel] = index.k;
    }
    return material;
}

}  // namespace

Material metalFromReflectance(glm::vec3 R0) noexcept {
    glm::vec3 edgeTint(0.0f);
    for (int channel = 0; channel < 3; ++channel) {
        edgeTint[channel] = nearestEdgeTint(clamped(R0[channel]));
    }
    return metalFrom(R0, edgeTint);
}

Material metalFromReflectance(glm::vec3 R0, glm::vec3 edgeTint) noexcept {
    return metalFrom(R0, glm::clamp(edgeTint, 0.0f, 1.0f));
}

}  // namespace tukor
