// The table of named materials. Metals for R, G, B at 650, 550 and 450 nm, interpolated linearly in
// the published tables; dielectrics at the sodium line. Abbe's numbers by the formulas of the same
// sources; those of the lecture's glass and water are fused quartz's and the CRC Handbook's.
#include <array>
#include <cctype>

#include "tukor/materials/materials.h"

namespace tukor {

namespace {

constexpr std::string_view kLecture = "[Szécsi, lecture 10]";
constexpr std::string_view kNoble = "[Johnson & Christy 1972]";
constexpr std::string_view kTransition = "[Johnson & Christy 1974]";
constexpr std::string_view kByEye =
    "index [Anderson 1990]; colour by eye at 2 m across, fitted to the size of the part";
constexpr std::string_view kRgb = "650, 550, 450";
constexpr std::string_view kSodium = "589.3";

constexpr MaterialFigures mirror(float tint) {
    return {MaterialKind::mirror, glm::vec3(tint)};
}

constexpr MaterialFigures metal(glm::vec3 eta, glm::vec3 k) {
    return {MaterialKind::metal, eta, k};
}

constexpr MaterialFigures solid(float eta, glm::vec3 sigmaA = glm::vec3(0.0f),
                                int priority = kSolidPriority) {
    return {MaterialKind::dielectric, glm::vec3(eta), sigmaA, priority};
}

constexpr MaterialFigures liquid(float eta, glm::vec3 sigmaA = glm::vec3(0.0f)) {
    return solid(eta, sigmaA, kLiquidPriority);
}

// Of objects 2 m across, as the built-in shapes are.
constexpr MaterialFigures coloured(float eta, glm::vec3 sigmaA) {
    return {MaterialKind::dielectric, glm::vec3(eta), sigmaA, kSolidPriority, 2.0f};
}

constexpr std::array kRows = {
    NamedMaterial{"mirror", "an ideal mirror", mirror(1.0f), "", "by definition"},
    NamedMaterial{"gold", "gold", metal({0.21f, 0.485f, 1.29f}, {3.13f, 2.23f, 1.76f}), "",
                  kLecture},
    NamedMaterial{"silver", "silver", metal({0.15f, 0.14f, 0.13f}, {3.7f, 3.11f, 2.47f}), "",
                  kLecture},
    NamedMaterial{"glass", "the glass of the lecture", solid(1.46f), "", kLecture, 67.8f},
    NamedMaterial{"water", "water, without its absorption", liquid(1.333f), "", kLecture, 55.8f},

    NamedMaterial{"copper", "copper", metal({0.238f, 1.007f, 1.240f}, {3.626f, 2.582f, 2.393f}),
                  kRgb, kNoble},
    NamedMaterial{"aluminium", "aluminium",
                  metal({1.420f, 0.966f, 0.590f}, {7.467f, 6.458f, 5.311f}), kRgb,
                  "[Rakic et al. 1998], Lorentz-Drude fit"},
    NamedMaterial{"iron", "iron", metal({2.911f, 2.950f, 2.584f}, {3.089f, 2.932f, 2.767f}), kRgb,
                  kTransition},
    NamedMaterial{"chromium", "chromium", metal({3.107f, 3.181f, 2.323f}, {3.331f, 3.329f, 3.135f}),
                  kRgb, kTransition},
    NamedMaterial{"nickel", "nickel", metal({1.990f, 1.921f, 1.729f}, {4.209f, 3.616f, 2.944f}),
                  kRgb, kTransition},
    NamedMaterial{"platinum", "platinum", metal({2.370f, 2.091f, 1.851f}, {4.254f, 3.704f, 3.140f}),
                  kRgb, "[Rakic et al. 1998], Lorentz-Drude fit"},
    NamedMaterial{"titanium", "titanium", metal({2.741f, 2.542f, 2.267f}, {3.814f, 3.435f, 3.038f}),
                  kRgb, kTransition},
    NamedMaterial{"brass", "brass: 70 % copper, 30 % zinc",
                  metal({0.444f, 0.527f, 1.094f}, {3.695f, 2.765f, 1.829f}), kRgb, "[Querry 1985]"},
    NamedMaterial{"palladium", "palladium",
                  metal({1.789f, 1.641f, 1.408f}, {4.375f, 3.845f, 3.254f}), kRgb, kTransition},
    NamedMaterial{"cobalt", "cobalt", metal({2.237f, 2.052f, 1.736f}, {4.236f, 3.824f, 3.274f}),
                  kRgb, kTransition},
    NamedMaterial{"tungsten", "tungsten", metal({3.671f, 3.522f, 3.315f}, {2.932f, 2.741f, 2.516f}),
                  kRgb, "[Weaver et al. 1975]"},

    NamedMaterial{"crown-glass", "borosilicate crown glass, N-BK7", solid(1.5168f), "587.6",
                  "[Schott 2023]", 64.17f},
    NamedMaterial{"flint-glass", "dense flint glass, SF11", solid(1.7847f), "587.6",
                  "[Schott 2023]", 25.76f},
    NamedMaterial{"window-glass", "clear soda-lime glass", solid(1.5233f), kSodium, "[Rubin 1985]"},
    NamedMaterial{"fused-quartz", "vitreous silica", solid(1.4584f), kSodium, "[Malitson 1965]",
                  67.8f},
    NamedMaterial{"acrylic", "poly(methyl methacrylate)", solid(1.4905f), kSodium,
                  "[Sultanova et al. 2009]", 53.2f},
    NamedMaterial{"polycarbonate", "polycarbonate", solid(1.5846f), kSodium,
                  "[Sultanova et al. 2009]", 27.9f},
    NamedMaterial{"ice", "ice, ordinary ray", solid(1.3091f, glm::vec3(0.0f), kIcePriority),
                  kSodium, "[CRC Handbook 2014]"},
    NamedMaterial{"rock-salt", "sodium chloride", solid(1.5443f), kSodium, "[Li 1976]", 42.9f},
    NamedMaterial{"quartz", "rock crystal, ordinary ray", solid(1.5442f), kSodium, "[Ghosh 1999]",
                  69.7f},
    NamedMaterial{"sapphire", "colourless sapphire, ordinary ray", solid(1.7682f), kSodium,
                  "[Malitson & Dodge 1972]", 72.3f},
    NamedMaterial{"cubic-zirconia", "cubic zirconia", solid(2.1588f), kSodium,
                  "[Wood & Nassau 1982]", 33.5f},
    NamedMaterial{"diamond", "diamond", solid(2.4173f), kSodium, "[Peter 1923]", 55.3f},
    NamedMaterial{"ethanol", "ethanol, 20 C", liquid(1.3611f), kSodium, "[CRC Handbook 2014]"},
    NamedMaterial{"glycerol", "glycerol, 20 C", liquid(1.4746f), kSodium, "[CRC Handbook 2014]"},
    NamedMaterial{"olive-oil", "olive oil, 20 C", liquid(1.4690f), kSodium,
                  "[Codex Alimentarius 33], middle of 1.4677 to 1.4705"},
    NamedMaterial{"deep-water", "water with its absorption, for pools and ponds",
                  liquid(1.333f, {0.340f, 0.0565f, 0.00922f}), kRgb, "[Pope & Fry 1997]", 55.8f},
    NamedMaterial{"air", "air, for bubbles: displaces whatever surrounds it",
                  solid(1.000277f, glm::vec3(0.0f), kBubblePriority), kSodium, "[Ciddor 1996]"},

    NamedMaterial{"ruby", "red corundum", coloured(1.7682f, {0.15f, 3.0f, 2.4f}), kSodium, kByEye,
                  72.3f},
    NamedMaterial{"emerald", "green beryl", coloured(1.579f, {2.2f, 0.25f, 1.4f}), kSodium, kByEye},
    NamedMaterial{"amber", "amber", coloured(1.540f, {0.15f, 0.75f, 3.0f}), kSodium, kByEye},
    NamedMaterial{
        "green-glass", "bottle glass", coloured(1.5233f, {1.2f, 0.2f, 0.9f}), kSodium,
        "index [Rubin 1985]; colour by eye at 2 m across, fitted to the size of the part"},
    NamedMaterial{
        "blue-glass", "cobalt glass", coloured(1.5233f, {2.5f, 1.4f, 0.1f}), kSodium,
        "index [Rubin 1985]; colour by eye at 2 m across, fitted to the size of the part"},
};

constexpr auto kTable = [] {
    auto rows = kRows;
#ifdef __EMSCRIPTEN__  // pages do not show where figures come from, and do not fetch it
    for (NamedMaterial& row : rows) row.description = row.wavelengths = row.source = {};
#endif
    return rows;
}();

constexpr auto kNames = [] {
    std::array<std::string_view, kTable.size()> names{};
    for (std::size_t i = 0; i < kTable.size(); ++i) names[i] = kTable[i].name;
    return names;
}();

bool equalIgnoringCase(std::string_view a, std::string_view b) noexcept {
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (std::tolower(static_cast<unsigned char>(a[i])) != b[i]) return false;
    }
    return true;
}

}  // namespace

std::span<const NamedMaterial> namedMaterials() noexcept {
    return kTable;
}

std::span<const std::string_view> materialNames() noexcept {
    return kNames;
}

Material NamedMaterial::material() const noexcept {
    switch (figures.kind) {
        case MaterialKind::mirror:
            return mirrorMaterial(figures.first);
        case MaterialKind::metal:
            return metalMaterial(figures.first, figures.second);
        case MaterialKind::dielectric:
            break;
    }
    Material material = dielectricMaterial(figures.first.x, figures.second, figures.priority);
    material.colourSize = figures.colourSize;
    return material;
}

float abbeNumberOf(const Material& material) noexcept {
    for (const NamedMaterial& named : kTable)
        if (named.abbe > 0.0f && named.material() == material) return named.abbe;
    return 0.0f;
}

std::optional<Material> findMaterial(std::string_view name) noexcept {
    for (const NamedMaterial& named : kTable) {
        if (equalIgnoringCase(name, named.name)) return named.material();
    }
    return std::nullopt;
}

}  // namespace tukor
