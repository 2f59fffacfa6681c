// The lobes of a finished surface, from the coat down, as one function of two directions: evaluated
// and sampled.
#pragma once
#include "tukor/trace/albedo_tables.h"
#include "tukor/trace/appearance.h"

namespace tukor::trace {

/// What light from `wi` becomes on its way to `wo`: the scattering function times the cosine.
struct LobeValue {
    glm::vec3 value{0.0f};
    float pdf = 0.0f;  // with which sample() gives `wi`, per steradian
};

struct LobeSample {
    glm::vec3 wi{0.0f};
    glm::vec3 weight{0.0f};  // value / pdf; zero: nothing is sent on
    float pdf = 0.0f;        // 0 for mirror-like lobes
    bool through = false;    // to the other side
};

/// Energy is kept in every layer: what reflects of uniform light and what goes on make 1. The base
/// is a mix of metal, of a matt dielectric under its own reflection, and of what lets light
/// through: a thin sheet, or a solid of `eta` = etaT / etaI, which bends it and has the albedo
/// `clear`.
class Layered {
public:
    enum class Base { opaque, thin, solid };

    Layered(const Appearance& look, Base base, float eta, const ClearAlbedo* clear,
            glm::vec3 wo) noexcept;

    [[nodiscard]] LobeValue eval(glm::vec3 wi) const noexcept;
    /// `u` are uniform in [0, 1).
    [[nodiscard]] LobeSample sample(float choice, glm::vec2 u) const noexcept;

private:
    /// A microfacet lobe in its own frame.
    struct Facets {
        glm::vec3 n, t, b;
        glm::vec3 wo;  // local
        glm::vec2 a;
        float lambdaOut;
        bool mirror;  // too sharp for anything but its one direction

        [[nodiscard]] glm::vec3 local(glm::vec3 w) const noexcept {
            return {glm::dot(w, t), glm::dot(w, b), glm::dot(w, n)};
        }
        [[nodiscard]] glm::vec3 world(glm::vec3 w) const noexcept {
            return w.x * t + w.y * b + w.z * n;
        }
    };
    enum Lobe { kCoat, kSheen, kSpecular, kDiffuse, kThrough, kLobes };

    static Facets facetsOf(glm::vec3 n, glm::vec3 t, glm::vec3 b, glm::vec2 a,
                           glm::vec3 wo) noexcept;
    /// Density of reflected directions, and D G2 / (4 cos) with it.
    struct FacetValue {
        float value = 0.0f;
        float pdf = 0.0f;
        float cosHalf = 0.0f;
    };
    static FacetValue reflected(const Facets& f, glm::vec3 wi) noexcept;
    [[nodiscard]] glm::vec3 specularColor(float cosHalf) const noexcept;
    [[nodiscard]] LobeValue evalThrough(glm::vec3 wi) const noexcept;
    [[nodiscard]] LobeSample sampleThrough(glm::vec2 u, float choice) const noexcept;

    Appearance look_;
    Base base_;
    float eta_;
    glm::vec3 wo_;
    Facets facets_, coatFacets_;
    float probability_[kLobes] = {};
    glm::vec3 coatWeight_;  // compensation of the coat's facets
    glm::vec3 below_;       // left of light below coat and sheen
    glm::vec3 metalBoost_, dielectricBoost_;
    glm::vec3 diffuse_;           // albedo, below all reflections
    glm::vec3 through_;           // colour of what is let in
    float clearScale_ = 1.0f;     // compensation of the clear facets
    float specularShare_ = 1.0f;  // of the dielectric's own reflection that is not in kThrough
};

}  // namespace tukor::trace
