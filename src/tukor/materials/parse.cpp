// `--material` values, and the ranges of their figures.
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/base/number_text.h"
#include "tukor/base/spelling.h"
#include "tukor/materials/figures.h"
#include "tukor/materials/materials.h"

namespace tukor {

namespace {

constexpr std::string_view kForms =
    "mirror:R,G,B, metal:R,G,B/R,G,B (eta / k), ior:N or ior:N/R,G,B (absorption in 1/m)"
#ifndef __EMSCRIPTEN__  // scene/material_text.h, which pages do without
    ", each with +rough:N (0 to 1) or without, as names; matt:R,G,B"
#endif
    ;
constexpr std::size_t kLongestShown = 80;  // of a bad value in a message

float parseNumber(std::string_view text, std::string_view whole) {
    const std::optional<double> value = numberFromText(text);
    if (!value) {
        throw Error(fmt::format("material '{}': '{}' is not a number; expected {}", shown(whole),
                                shown(text), kForms));
    }
    return static_cast<float>(*value);
}

}  // namespace

std::string shown(std::string_view text) {
    if (text.size() <= kLongestShown) return std::string(text);
    return std::string(text.substr(0, kLongestShown)) + "...";
}

glm::vec3 parseColour(std::string_view text, std::string_view whole) {
    std::array<float, 3> values{};
    std::size_t count = 0;
    for (std::string_view rest = text;;) {
        const std::size_t comma = rest.find(',');
        if (count == values.size()) {
            count = 4;
            break;
        }
        values[count++] = parseNumber(rest.substr(0, comma), whole);
        if (comma == std::string_view::npos) break;
        rest.remove_prefix(comma + 1);
    }
    if (count == 1) return glm::vec3(values[0]);
    if (count != 3) {
        throw Error(fmt::format("material '{}': '{}' has {} numbers; expected one or three (R,G,B)",
                                shown(whole), shown(text), count == 2 ? "two" : "more than three"));
    }
    return {values[0], values[1], values[2]};
}

namespace {

Material parseFigures(std::string_view kind, std::string_view figures, std::string_view text) {
    const std::size_t slash = figures.find('/');
    const std::string_view first = figures.substr(0, slash);
    const bool two = slash != std::string_view::npos;
    const std::string_view second = two ? figures.substr(slash + 1) : std::string_view();
    if (kind == "mirror") return mirrorMaterial(parseColour(figures, text));
    if (kind == "ior") {
        return dielectricMaterial(parseNumber(first, text),
                                  two ? parseColour(second, text) : glm::vec3(0.0f));
    }
    if (!two) {
        throw Error(fmt::format(
            "material '{}': a metal needs eta and k; expected metal:R,G,B/R,G,B", shown(text)));
    }
    return metalMaterial(parseColour(first, text), parseColour(second, text));
}

}  // namespace

void checkRange(std::string_view name, std::string_view figure, glm::vec3 values, float least,
                float most) {
    for (int channel = 0; channel < 3; ++channel) {
        const float value = values[channel];
        if (!(value >= least && value <= most)) {  // NaN fails too
            throw Error(fmt::format("material '{}': {} {}; expected {} to {}", name, figure, value,
                                    least, most));
        }
    }
}

Material mirrorMaterial(glm::vec3 tint) noexcept {
    Material material;
    material.kind = MaterialKind::mirror;
    material.tint = tint;
    return material;
}

Material metalMaterial(glm::vec3 eta, glm::vec3 k) noexcept {
    Material material;
    material.kind = MaterialKind::metal;
    material.eta = eta;
    material.k = k;
    return material;
}

Material dielectricMaterial(float eta, glm::vec3 sigmaA, int priority) noexcept {
    Material material;
    material.kind = MaterialKind::dielectric;
    material.eta = glm::vec3(eta);
    material.sigmaA = sigmaA;
    material.priority = priority;
    return material;
}

void checkMaterial(const Material& material, std::string_view name) {
    const std::string shownName = shown(name);
    switch (material.kind) {
        case MaterialKind::mirror:
            checkRange(shownName, "reflectance", material.tint, 0.0f, 1.0f);
            break;
        case MaterialKind::metal:
            checkRange(shownName, "eta", material.eta, 1e-3f, 1e3f);
            checkRange(shownName, "k", material.k, 0.0f, 1e3f);
            break;
        case MaterialKind::dielectric:
            checkRange(shownName, "index", material.eta, 1e-3f, 1e3f);
            checkRange(shownName, "absorption", material.sigmaA, 0.0f, 1e30f);
            break;
    }
}

Material parseMaterial(std::string_view text) {
    if (const std::optional<Material> named = findMaterial(text)) return *named;
    const std::size_t colon = text.find(':');
    const std::string_view kind = text.substr(0, colon);
    if (colon != std::string_view::npos && (kind == "mirror" || kind == "metal" || kind == "ior")) {
        Material material = parseFigures(kind, text.substr(colon + 1), text);
        checkMaterial(material, text);
        return material;
    }
    const std::string_view nearest = nearestName(text, materialNames());
    throw Error(fmt::format("unknown material '{}'{}; known are {}; or figures: {}", shown(text),
                            nearest.empty() ? "" : fmt::format("; did you mean '{}'?", nearest),
                            fmt::join(materialNames(), ", "), kForms));
}

}  // namespace tukor
