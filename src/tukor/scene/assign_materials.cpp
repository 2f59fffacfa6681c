#include "tukor/scene/assign_materials.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "tukor/base/error.h"
#include "tukor/geometry/closedness.h"
#include "tukor/scene/material_text.h"

namespace tukor {

namespace {

constexpr std::size_t kListed = 20;  // names in a message: a model may have thousands

std::string partNames(const Scene& scene) {
    std::set<std::string> distinct;
    for (const Part& part : scene.parts) {
        if (!part.name.empty()) distinct.insert(part.name);
        if (!part.materialName.empty()) distinct.insert(part.materialName);
    }
    std::vector<std::string> listed(distinct.begin(), distinct.end());
    if (listed.empty()) return "its parts have no names";
    const std::size_t left = listed.size() - std::min(listed.size(), kListed);
    listed.resize(listed.size() - left);
    const std::string more = left > 0 ? fmt::format(" and {} more", left) : "";
    return fmt::format("there are {}{}", fmt::join(listed, ", "), more);
}

#ifdef __EMSCRIPTEN__  // a page's rough surfaces show no dispersion
constexpr auto& abbeNumberInside = abbeNumberOf;
#else
/// Whatever the surface.
float abbeNumberInside(const Material& material) {
    Material smooth = material;
    smooth.finish.reset();
    return abbeNumberOf(smooth);
}
#endif

char lower(char c) {
    return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
}

}  // namespace

bool matchesPattern(std::string_view text, std::string_view pattern) noexcept {
    std::size_t t = 0, p = 0;
    std::size_t star = std::string_view::npos, resume = 0;  // where to widen the last `*`
    while (t < text.size()) {
        if (p < pattern.size() && pattern[p] == '*') {
            star = p++;
            resume = t;
        } else if (p < pattern.size() &&
                   (pattern[p] == '?' || lower(pattern[p]) == lower(text[t]))) {
            ++p;
            ++t;
        } else if (star != std::string_view::npos) {
            p = star + 1;
            t = ++resume;
        } else {
            return false;
        }
    }
    while (p < pattern.size() && pattern[p] == '*') ++p;
    return p == pattern.size();
}

void assignMaterials(Scene& scene, std::span<const std::string> specifications) {
    for (const std::string& specification : specifications) {
        const std::size_t equals = specification.rfind('=');  // no material's name has one
        const bool forAll = equals == std::string::npos;
        const std::string pattern = forAll ? "*" : specification.substr(0, equals);
        const Material material =
            materialFromText(forAll ? specification : specification.substr(equals + 1));
        bool matched = forAll;
        for (Part& part : scene.parts)
            if (matchesPattern(part.name, pattern) || matchesPattern(part.materialName, pattern)) {
                part.material = material;
                matched = true;
            }
        if (!matched)
            throw Error(
                fmt::format("material '{}': no part or material of the model matches '{}'; {}",
                            specification, pattern, partNames(scene)));
    }
}

void setDispersion(Scene& scene, float factor) {
    for (Part& part : scene.parts) {
        Material& material = part.material;
        const float abbe = abbeNumberInside(material);
        material.dispersion = factor * (abbe > 0.0f ? 20.0f / abbe : material.dispersion);
    }
}

void append(Scene& scene, Scene added) {
    const auto move = [](auto& to, auto& from) {
        to.insert(to.end(), std::move_iterator(from.begin()), std::move_iterator(from.end()));
    };
    move(scene.parts, added.parts);
    move(scene.cameras, added.cameras);
    move(scene.lights, added.lights);
    move(scene.warnings, added.warnings);
}

std::vector<std::string> closednessWarnings(const Scene& scene) {
    std::vector<std::string> warnings;
    std::vector<bool> done(scene.parts.size(), false);
    for (std::size_t i = 0; i < scene.parts.size(); ++i) {
        const Part& part = scene.parts[i];
        if (done[i] || part.material.kind != MaterialKind::dielectric) continue;
        Mesh solid;
        for (std::size_t j = i; j < scene.parts.size(); ++j) {
            const Part& other = scene.parts[j];
            if (other.material != part.material || other.materialName != part.materialName)
                continue;
            done[j] = true;
            const auto base = static_cast<unsigned>(solid.positions.size());
            solid.positions.insert(solid.positions.end(), other.mesh.positions.begin(),
                                   other.mesh.positions.end());
            for (const glm::uvec3 t : other.mesh.triangles) solid.triangles.push_back(t + base);
        }
        const std::string warning = warningOf(checkClosed(solid));
        if (warning.empty()) continue;
        const std::string& name = part.materialName.empty() ? part.name : part.materialName;
        warnings.push_back(name.empty() ? warning : fmt::format("{}: {}", name, warning));
    }
    return warnings;
}

}  // namespace tukor
