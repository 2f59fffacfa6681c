// The built-in shapes by name: sphere, torus-knot, teapot and others.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tukor/geometry/mesh.h"

namespace tukor {

/// One closed surface of a shape. `material` names the material it has unless the user says
/// otherwise; empty: the default.
struct ShapePart {
    std::string name;
    std::string material;
    Mesh mesh;
};

/// The names that makeShape knows, in the order of the documentation.
[[nodiscard]] std::vector<std::string_view> shapeNames();

/// A built-in shape around the origin, about 2 m across unless its docs say otherwise; none when
/// the name is unknown.
[[nodiscard]] std::optional<std::vector<ShapePart>> makeShape(std::string_view name);

}  // namespace tukor
