#include "tukor/scene/gltf_lights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "tukor/scene/sibling_file.h"

namespace tukor {

Light readGltfLight(const GltfDocument& document, const GltfPlaced& placed) {
    const JsonItem root = document.root();
    const std::optional<JsonItem> extensions = root.find("extensions");
    const std::optional<JsonItem> extension =
        extensions ? extensions->find("KHR_lights_punctual") : std::nullopt;
    const std::size_t count = extension ? extension->list("lights").size() : 0;
    if (placed.index >= count)
        root.fail(fmt::format("{} refers to lights[{}]; there are {}",
                              document.item("nodes", placed.node, root).where(), placed.index,
                              count));
    const JsonItem item = extension->list("lights")[placed.index];
    Light light;
    light.name = item.textOr("name", placed.name);
    const std::string type(item.at("type").text());
    if (type == "directional")
        light.kind = LightKind::directional;
    else if (type == "point")
        light.kind = LightKind::point;
    else if (type == "spot")
        light.kind = LightKind::spot;
    else
        item.fail(fmt::format("type '{}'; expected directional, point or spot", printable(type)));
    const auto colour = item.numbers<3>("color").value_or(std::array<double, 3>{1.0, 1.0, 1.0});
    light.intensity = glm::max(glm::vec3(colour[0], colour[1], colour[2]), glm::vec3(0.0f)) *
                      static_cast<float>(std::clamp(item.numberOr("intensity", 1.0), 0.0, 1e9));
    light.range = static_cast<float>(std::max(item.numberOr("range", 0.0), 0.0));
    if (const std::optional<JsonItem> spot = item.find("spot")) {
        const double inner = std::clamp(spot->numberOr("innerConeAngle", 0.0), 0.0, 1.5707963);
        const double outer =
            std::clamp(spot->numberOr("outerConeAngle", 0.7853982), 0.0, 1.5707963);
        light.cosInner = static_cast<float>(std::cos(inner));
        light.cosOuter = static_cast<float>(std::cos(outer));
    }
    light.position = glm::vec3(placed.worldFromNode[3]);
    const glm::dvec3 forward = -glm::dvec3(placed.worldFromNode[2]);
    const double length = glm::length(forward);
    if (length > 0.0) light.direction = glm::vec3(forward / length);
    return light;
}

}  // namespace tukor
