#include "tukor/scene/gltf_instances.h"

#include <optional>

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include "tukor/scene/gltf_accessor.h"

namespace tukor {

std::vector<glm::dmat4> instancesOf(const GltfDocument& document, const JsonItem& extension,
                                    std::size_t most) {
    const JsonItem attributes = extension.at("attributes");
    std::optional<std::size_t> count;
    const auto accessor = [&](const char* name, int components) -> std::optional<GltfAccessor> {
        const std::optional<JsonItem> index = attributes.find(name);
        if (!index) return std::nullopt;
        GltfAccessor found(document, index->count(), attributes);
        found.requireComponents(components, components);
        if (count && *count != found.count())
            attributes.fail(fmt::format("{} has {} elements; expected {} as the others have", name,
                                        found.count(), *count));
        count = found.count();
        return found;
    };
    const auto translation = accessor("TRANSLATION", 3);
    const auto rotation = accessor("ROTATION", 4);
    const auto scale = accessor("SCALE", 3);
    if (count.value_or(0) > most)
        attributes.fail(fmt::format("{} instances; at most {} can be drawn", *count, most));
    std::vector<glm::dmat4> instances;
    for (std::size_t i = 0; i < count.value_or(0); ++i) {
        glm::dmat4 m(1.0);
        if (translation) m = glm::translate(m, glm::dvec3(translation->vec3(i)));
        if (rotation) {
            const glm::dvec4 r(rotation->vec4(i));
            const glm::dquat q(r.w, r.x, r.y, r.z);
            if (!(glm::length(q) > 0.0)) attributes.fail("a rotation without a direction");
            m *= glm::mat4_cast(glm::normalize(q));
        }
        if (scale) m = glm::scale(m, glm::dvec3(scale->vec3(i)));
        instances.push_back(m);
    }
    return instances;
}

}  // namespace tukor
