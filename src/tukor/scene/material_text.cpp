#include "tukor/scene/material_text.h"

#include <algorithm>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/base/number_text.h"
#include "tukor/materials/figures.h"
#include "tukor/optics/fresnel.h"
#include "tukor/scene/finish.h"
#include "tukor/scene/surface.h"

namespace tukor {

namespace {

constexpr std::string_view kRough = "+rough:";
constexpr std::string_view kMatt = "matt:";

/// Where the finish begins: at the first plus that is neither sign of a figure nor of its exponent.
std::size_t finishIn(std::string_view text) noexcept {
    constexpr std::string_view kDigits = "0123456789.", kBeforeFigures = ":,/";
    std::size_t plus = text.find('+');
    for (; plus != std::string_view::npos; plus = text.find('+', plus + 1)) {
        const char before = plus > 0 ? text[plus - 1] : ' ';
        const bool exponent = (before == 'e' || before == 'E') && plus > 1 &&
                              kDigits.find(text[plus - 2]) != kDigits.npos;
        if (!exponent && kBeforeFigures.find(before) == kBeforeFigures.npos) break;
    }
    return plus;
}

float roughnessFrom(std::string_view finish, std::string_view whole) {
    if (!finish.starts_with(kRough))
        throw Error(
            fmt::format("material '{}': '{}' is unknown; expected +rough:N with N from 0 to 1",
                        shown(whole), shown(finish)));
    const std::string_view figure = finish.substr(kRough.size());
    const std::optional<double> roughness = numberFromText(figure);
    if (!roughness)
        throw Error(
            fmt::format("material '{}': '{}' is not a number; expected +rough:N with N from 0 to 1",
                        shown(whole), shown(figure)));
    checkRange(shown(whole), "roughness", glm::vec3(static_cast<float>(*roughness)), 0.0f, 1.0f);
    return static_cast<float>(*roughness);
}

Finish roughFinish(const Material& smooth, float roughness) {
    Finish finish;
    finish.ignoresColors = true;
    finish.roughness = roughness;
    switch (smooth.kind) {
        case MaterialKind::metal:
            finish.baseColor = optics::reflectanceAtNormal(smooth.eta, smooth.k);
            return finish;
        case MaterialKind::mirror: {
            const float most = std::max({smooth.tint.x, smooth.tint.y, smooth.tint.z});
            finish.metallic = 0.0f;  // whose reflectance would rise to 1 along the surface
            finish.baseColor = glm::vec3(0.0f);
            finish.ior = 0.0f;  // glTF's word for what reflects everything at any angle
            finish.specular = most;
            finish.specularColor = most > 0.0f ? smooth.tint / most : glm::vec3(1.0f);
            return finish;
        }
        case MaterialKind::dielectric:
            break;
    }
    finish.metallic = 0.0f;
    finish.transmission = 1.0f;
    finish.ior = smooth.eta.x;
    return finish;
}

Material mattMaterial(glm::vec3 colour) {
    Finish finish;
    finish.ignoresColors = true;
    finish.baseColor = colour;
    finish.metallic = 0.0f;
    Material material = mirrorMaterial(colour);
    material.finish = std::make_shared<Finish>(finish);
    return material;
}

}  // namespace

Material materialFromText(std::string_view text) {
    const std::size_t plus = finishIn(text);
    const std::string_view base = text.substr(0, plus);
    if (base.starts_with(kMatt)) {
        const glm::vec3 colour = parseColour(base.substr(kMatt.size()), text);
        checkRange(shown(text), "base colour", colour, 0.0f, 1.0f);
        if (plus != std::string_view::npos)
            throw Error(
                fmt::format("material '{}': nothing is rougher than matt; expected a metal, a "
                            "mirror or a clear material before '{}'",
                            shown(text), shown(text.substr(plus))));
        return mattMaterial(colour);
    }
    Material material = parseMaterial(base);
    if (plus == std::string_view::npos) return material;
    const float roughness = roughnessFrom(text.substr(plus), text);
    if (roughness > kPolished)
        material.finish = std::make_shared<Finish>(roughFinish(material, roughness));
    return material;
}

}  // namespace tukor
