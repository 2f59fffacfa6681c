#include "tukor/trace/layered.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tukor/optics/directions.h"
#include "tukor/optics/fresnel.h"
#include "tukor/optics/microfacet.h"

namespace tukor::trace {

namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kMirrorAlpha =
    0.0025f;  // a perceptual roughness of 0.05, as scene/surface.cpp has it

float mean(glm::vec3 v) noexcept {
    return (v.x + v.y + v.z) / 3.0f;
}

float largest(glm::vec3 v) noexcept {
    return std::max(v.x, std::max(v.y, v.z));
}

glm::vec3 cosineDirection(glm::vec2 u) noexcept {
    const float r = std::sqrt(u.x), phi = 2.0f * kPi * u.y;
    return {r * std::cos(phi), r * std::sin(phi), std::sqrt(std::max(1.0f - u.x, 0.0f))};
}

/// Fibres of [Estevez & Kulla 2017], visible as [Neubelt & Pettineo 2013] have it.
float sheenValue(float cosHalf, float cosOut, float cosIn, float alpha) noexcept {
    const float inverse = 1.0f / alpha;
    const float sin = std::sqrt(std::max(1.0f - cosHalf * cosHalf, 0.0f));
    return (2.0f + inverse) * std::pow(sin, inverse) / (2.0f * kPi) /
           (4.0f * (cosOut + cosIn - cosOut * cosIn));
}

}  // namespace

Layered::Facets Layered::facetsOf(glm::vec3 n, glm::vec3 t, glm::vec3 b, glm::vec2 a,
                                  glm::vec3 wo) noexcept {
    Facets f{n, t, b, glm::vec3(0.0f), a, 0.0f, std::max(a.x, a.y) < kMirrorAlpha};
    f.wo = f.local(wo);
    f.wo.z = std::max(f.wo.z, 1e-4f);
    f.lambdaOut = optics::ggxLambda(f.wo, a);
    return f;
}

Layered::Layered(const Appearance& look, Base base, float eta, const ClearAlbedo* clear,
                 glm::vec3 wo) noexcept
    : look_(look),
      base_(base),
      eta_(eta),
      wo_(wo),
      facets_(facetsOf(look.n, look.t, look.b, look.a, wo)) {
    const float cosOut = facets_.wo.z;
    below_ = glm::vec3(1.0f);
    coatWeight_ = glm::vec3(0.0f);
    if (look.coat > 0.0f) {
        const float alpha = std::max(look.coatRoughness * look.coatRoughness, 1e-4f);
        const glm::vec3 t = glm::normalize(
            glm::cross(look.coatNormal, std::abs(look.coatNormal.x) < 0.5f ? glm::vec3(1, 0, 0)
                                                                           : glm::vec3(0, 1, 0)));
        coatFacets_ =
            facetsOf(look.coatNormal, t, glm::cross(look.coatNormal, t), glm::vec2(alpha), wo);
        const glm::vec3 table = splitAlbedo(coatFacets_.wo.z, look.coatRoughness);
        const glm::vec3 albedo =
            optics::compensatedReflectance(glm::vec3(0.04f), glm::vec3(1.0f), glm::vec2(table));
        coatWeight_ = glm::vec3(look.coat) *
                      (1.0f + 0.04f * (1.0f / std::max(table.x + table.y, 1e-3f) - 1.0f));
        probability_[kCoat] = look.coat * albedo.x;
        below_ *= 1.0f - look.coat * albedo.x;
    }
    const float strongestSheen = largest(look.sheen);
    if (strongestSheen > 0.0f) {
        const float albedo =
            std::min(splitAlbedo(cosOut, look.sheenRoughness).z, 1.0f / strongestSheen);
        probability_[kSheen] = mean(below_) * strongestSheen * albedo;
        look_.sheen *= below_;
        below_ *= 1.0f - strongestSheen * albedo;
    }

    const glm::vec2 table(splitAlbedo(cosOut, look.roughness));
    const float missing = 1.0f / std::max(table.x + table.y, 1e-3f) - 1.0f;
    metalBoost_ = 1.0f + look.metalF0 * missing;
    dielectricBoost_ = 1.0f + look.F0 * missing;
    const glm::vec3 metal = optics::compensatedReflectance(look.metalF0, glm::vec3(1.0f), table);
    const glm::vec3 dielectric = optics::compensatedReflectance(look.F0, look.F90, table);
    const float matt = 1.0f - look.metallic;
    specularShare_ = base == Base::solid ? 0.0f : 1.0f;
    if (clear != nullptr)
        clearScale_ = 1.0f / std::max(clear->at(cosOut, std::sqrt(look.a.x * look.a.y)), 1e-3f);
    const glm::vec3 entering = base == Base::solid ? glm::vec3(1.0f) : 1.0f - dielectric;
    diffuse_ = matt * (1.0f - (base == Base::opaque ? 0.0f : look.transmission)) * look.baseColor *
               (1.0f - dielectric);
    through_ = base == Base::opaque ? glm::vec3(0.0f)
                                    : matt * look.transmission * look.baseColor * entering;
    const float rest = mean(below_);
    probability_[kSpecular] =
        rest * mean(look.metallic * metal + matt * specularShare_ * dielectric);
    probability_[kDiffuse] = rest * mean(diffuse_);
    probability_[kThrough] = base == Base::solid ? rest * matt : rest * mean(through_);
    float sum = 0.0f;
    for (const float p : probability_) sum += p;
    for (float& p : probability_) p = sum > 0.0f ? p / sum : 0.0f;
}

Layered::FacetValue Layered::reflected(const Facets& f, glm::vec3 world) noexcept {
    FacetValue result;
    const glm::vec3 wi = f.local(world);
    if (wi.z <= 0.0f || f.mirror) return result;
    const glm::vec3 h = glm::normalize(wi + f.wo);
    const float D = optics::ggxDistribution(h, f.a);
    const float common = D / (4.0f * f.wo.z);
    result.cosHalf = std::clamp(glm::dot(wi, h), 0.0f, 1.0f);
    result.value = common / (1.0f + f.lambdaOut + optics::ggxLambda(wi, f.a));
    result.pdf = common / (1.0f + f.lambdaOut);
    return result;
}

glm::vec3 Layered::specularColor(float cosHalf) const noexcept {
    const float m = 1.0f - cosHalf;
    const float grazing = m * m * m * m * m;
    const glm::vec3 metal = glm::mix(look_.metalF0, glm::vec3(1.0f), grazing) * metalBoost_;
    const glm::vec3 other = glm::mix(look_.F0, look_.F90, grazing) * dielectricBoost_;
    return look_.metallic * metal + (1.0f - look_.metallic) * specularShare_ * other;
}

LobeValue Layered::evalThrough(glm::vec3 world) const noexcept {
    LobeValue result;
    if (facets_.mirror || probability_[kThrough] <= 0.0f) return result;
    if (base_ == Base::thin) {
        const glm::vec3 mirrored = world - 2.0f * glm::dot(world, look_.n) * look_.n;
        const FacetValue f = reflected(facets_, mirrored);
        const glm::vec2 table(splitAlbedo(facets_.wo.z, look_.roughness));
        result.value = through_ * (f.value / std::max(table.x + table.y, 1e-3f));
        result.pdf = f.pdf;
        return result;
    }
    const glm::vec3 wi = facets_.local(world);
    const float matt = 1.0f - look_.metallic;
    if (wi.z > 0.0f) {
        const FacetValue f = reflected(facets_, world);
        const float R = optics::fresnelDielectric(f.cosHalf, eta_);
        result.value = glm::vec3(matt * R * f.value * clearScale_);
        result.pdf = R * f.pdf;
        return result;
    }
    glm::vec3 h = -(facets_.wo + eta_ * wi);
    if (h.z < 0.0f) h = -h;
    const float length = glm::length(h);
    if (!(length > 1e-6f)) return result;
    h /= length;
    const float cosOut = glm::dot(facets_.wo, h), cosIn = glm::dot(wi, h);
    if (cosOut <= 0.0f || cosIn >= 0.0f) return result;
    const float T = 1.0f - optics::fresnelDielectric(std::min(cosOut, 1.0f), eta_);
    const float root = cosOut + eta_ * cosIn;
    const float D = optics::ggxDistribution(h, facets_.a);
    const float common =
        T * D * cosOut / facets_.wo.z * (eta_ * eta_ * -cosIn) / std::max(root * root, 1e-12f);
    result.value = through_ * (common * clearScale_ /
                               (1.0f + facets_.lambdaOut + optics::ggxLambda(wi, facets_.a)));
    result.pdf = common / (1.0f + facets_.lambdaOut);
    return result;
}

LobeValue Layered::eval(glm::vec3 wi) const noexcept {
    LobeValue sum;
    const float cosIn = glm::dot(wi, look_.n);
    if (look_.coat > 0.0f) {
        const FacetValue f = reflected(coatFacets_, wi);
        const float m = 1.0f - f.cosHalf;
        sum.value += coatWeight_ * (0.04f + 0.96f * m * m * m * m * m) * f.value;
        sum.pdf += probability_[kCoat] * f.pdf;
    }
    if (cosIn > 0.0f) {
        if (probability_[kSheen] > 0.0f) {
            const glm::vec3 h = glm::normalize(wi + wo_);
            sum.value +=
                look_.sheen *
                (cosIn * sheenValue(glm::dot(h, look_.n), facets_.wo.z, cosIn,
                                    std::max(look_.sheenRoughness * look_.sheenRoughness, 1e-3f)));
            sum.pdf += probability_[kSheen] * cosIn / kPi;
        }
        if (probability_[kSpecular] > 0.0f) {
            const FacetValue f = reflected(facets_, wi);
            sum.value += below_ * specularColor(f.cosHalf) * f.value;
            sum.pdf += probability_[kSpecular] * f.pdf;
        }
        sum.value += below_ * diffuse_ * (cosIn / kPi);
        sum.pdf += probability_[kDiffuse] * cosIn / kPi;
    }
    if (base_ == Base::solid || (base_ == Base::thin && cosIn < 0.0f)) {
        const LobeValue f = evalThrough(wi);
        sum.value += below_ * f.value;
        sum.pdf += probability_[kThrough] * f.pdf;
    }
    return sum;
}

LobeSample Layered::sampleThrough(glm::vec2 u, float choice) const noexcept {
    LobeSample s;
    const float p = probability_[kThrough];
    if (base_ == Base::thin) {
        s.through = true;
        if (facets_.mirror) {
            s.wi = -wo_;
            s.weight = below_ * through_ / p;
            return s;
        }
        const glm::vec3 h = optics::ggxVisibleNormal(facets_.wo, facets_.a, u);
        const glm::vec3 wi = 2.0f * glm::dot(facets_.wo, h) * h - facets_.wo;
        if (wi.z > 0.0f) s.wi = facets_.world({wi.x, wi.y, -wi.z});
        return s;
    }
    const glm::vec3 h = facets_.mirror ? glm::vec3(0.0f, 0.0f, 1.0f)
                                       : optics::ggxVisibleNormal(facets_.wo, facets_.a, u);
    const float cosOut = std::clamp(glm::dot(facets_.wo, h), 0.0f, 1.0f);
    const optics::Refraction refraction = optics::refractDirection(-facets_.wo, h, eta_);
    const float R = refraction.total ? 1.0f : optics::fresnelDielectric(cosOut, eta_);
    s.through = choice >= R;
    const glm::vec3 wi = s.through ? refraction.direction : 2.0f * cosOut * h - facets_.wo;
    s.wi = facets_.world(wi);
    if (facets_.mirror)
        s.weight = below_ * (s.through ? through_ : glm::vec3(1.0f - look_.metallic)) / p;
    else if (s.through != (wi.z < 0.0f))
        s.wi = glm::vec3(0.0f);
    return s;
}

LobeSample Layered::sample(float choice, glm::vec2 u) const noexcept {
    LobeSample s;
    int lobe = 0;
    while (lobe < kLobes - 1 && choice >= probability_[lobe]) choice -= probability_[lobe++];
    const float p = probability_[lobe];
    if (!(p > 0.0f)) return s;
    choice = std::min(choice / p, 0.9999999f);
    const auto mirrored = [&](const Facets& f) {
        const glm::vec3 h =
            f.mirror ? glm::vec3(0.0f, 0.0f, 1.0f) : optics::ggxVisibleNormal(f.wo, f.a, u);
        const glm::vec3 wi = 2.0f * glm::dot(f.wo, h) * h - f.wo;
        return wi.z > 0.0f ? f.world(wi) : glm::vec3(0.0f);
    };
    switch (lobe) {
        case kCoat: {
            s.wi = mirrored(coatFacets_);
            const float m = 1.0f - coatFacets_.wo.z;
            if (coatFacets_.mirror)
                s.weight = coatWeight_ * (0.04f + 0.96f * m * m * m * m * m) / p;
            break;
        }
        case kSpecular:
            s.wi = mirrored(facets_);
            if (facets_.mirror) s.weight = below_ * specularColor(facets_.wo.z) / p;
            break;
        case kThrough:
            s = sampleThrough(u, choice);
            break;
        default:
            s.wi = facets_.world(cosineDirection(u));
            break;
    }
    if (s.wi == glm::vec3(0.0f) || s.weight != glm::vec3(0.0f)) return s;
    s.wi = glm::normalize(s.wi);
    const LobeValue value = eval(s.wi);
    if (!(value.pdf > 1e-9f)) return {};
    s.weight = value.value / value.pdf;
    s.pdf = value.pdf;
    return s;
}

}  // namespace tukor::trace
