// `tukor materials`: the named materials with their figures and sources.
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "command.h"
#include "tukor/app/option_text.h"
#include "tukor/base/number_text.h"
#include "tukor/materials/materials.h"

namespace tukor {
namespace {

std::string_view kindName(MaterialKind kind) {
    switch (kind) {
        case MaterialKind::mirror:
            return "mirror";
        case MaterialKind::metal:
            return "metal";
        case MaterialKind::dielectric:
            return "dielectric";
    }
    return "";
}

/// The figures in the syntax of --material.
std::string figures(const Material& material) {
    switch (material.kind) {
        case MaterialKind::mirror:
            return "mirror:" + textFromValue(material.tint);
        case MaterialKind::metal:
            return "metal:" + textFromValue(material.eta) + "/" + textFromValue(material.k);
        case MaterialKind::dielectric:
            return "ior:" + textFromValue(material.eta.x) +
                   (material.sigmaA == glm::vec3(0.0f) ? "" : "/" + textFromValue(material.sigmaA));
    }
    return {};
}

void printTable() {
    fmt::print("{:<16}{:<44}{:<28}{}\n", "name", "figures", "wavelengths",
               "description and source");
    for (const NamedMaterial& row : namedMaterials()) {
        const std::string abbe = row.abbe > 0.0f ? fmt::format("  Abbe {}", row.abbe) : "";
        fmt::print("{:<16}{:<44}{:<28}{}{}{}\n", row.name, figures(row.material()) + abbe,
                   row.wavelengths.empty() ? "-" : row.wavelengths, row.description,
                   row.source.starts_with('[') ? " " : ", ", row.source);
    }
    fmt::print(
        "\nAlso from figures: --material ior:1.2, ior:1.5/0.1,0.2,0.9 (with absorption in 1/m),\n"
        "metal:0.21,0.485,1.29/3.13,2.23,1.76 (eta/k for R,G,B), mirror:0.9,0.8,0.7 "
        "(reflectance)\n"
        "\nRough, by glTF's roughness from 0 to 1, after any of these: gold+rough:0.2, "
        "glass+rough:0.3 (frosted).\n"
        "Up to 0.05 it is the smooth material. Rough metals have their reflectance at normal "
        "incidence,\nand by Schlick's approximation at other angles.\n"
        "Matt colours, linear: matt:0.8,0.2,0.1 (as glTF's metallic 0, roughness 1)\n");
}

void printJson() {
    auto all = nlohmann::ordered_json::array();
    const auto number = [](float v) { return numberFromText(textFromValue(v)).value(); };
    const auto list = [&](glm::vec3 v) {
        return nlohmann::ordered_json{number(v.x), number(v.y), number(v.z)};
    };
    for (const NamedMaterial& row : namedMaterials()) {
        const Material material = row.material();
        nlohmann::ordered_json one;
        one["name"] = row.name;
        one["kind"] = kindName(material.kind);
        one["description"] = row.description;
        if (material.kind == MaterialKind::mirror) {
            one["tint"] = list(material.tint);
        } else {
            one["eta"] = list(material.eta);
        }
        if (material.kind == MaterialKind::metal) one["k"] = list(material.k);
        if (material.kind == MaterialKind::dielectric) {
            one["sigmaA"] = list(material.sigmaA);
            if (material.colourSize > 0.0f) one["colourSize"] = material.colourSize;
            one["priority"] = material.priority;
            if (row.abbe > 0.0f) one["abbe"] = number(row.abbe);
        }
        one["wavelengths"] = row.wavelengths;
        one["source"] = row.source;
        all.push_back(std::move(one));
    }
    fmt::print("{}\n", all.dump(2));
}

}  // namespace

Command materialsCommand() {
    auto json = std::make_shared<bool>(false);
    return {.name = "materials",
            .help = "the named materials, their figures and sources",
            .options = {flagOption(
                "--json", *json, "as JSON: eta and k for R, G, B, sigmaA in 1/m, colourSize in m")},
            .run = [json] {
                *json ? printJson() : printTable();
                return 0;
            }};
}

}  // namespace tukor
