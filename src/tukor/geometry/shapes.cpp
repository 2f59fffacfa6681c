#include "tukor/geometry/shapes.h"

#include <utility>

#include "tukor/geometry/brilliant.h"
#include "tukor/geometry/sphere.h"
#include "tukor/geometry/teapot.h"
#include "tukor/geometry/torus_knot.h"
#include "tukor/geometry/tumbler.h"
#include "tukor/geometry/water_surface.h"

namespace tukor {

namespace {

ShapePart part(std::string_view name, std::string_view material, Mesh mesh) {
    return {std::string(name), std::string(material), std::move(mesh)};
}

std::vector<ShapePart> teapot() {
    Teapot pot = makeTeapot();
    return {part("body", "", std::move(pot.body)), part("spout", "", std::move(pot.spout)),
            part("handle", "", std::move(pot.handle))};
}

std::vector<ShapePart> tumbler() {
    Tumbler filled = makeTumbler();
    return {part("glass", "glass", std::move(filled.glass)),
            part("water", "water", std::move(filled.water))};
}

struct NamedShape {
    std::string_view name;
    std::vector<ShapePart> (*make)();
};

constexpr NamedShape kShapes[] = {
    // 84,500 triangles: the picture of a glass ball is then 0.4/255 from the true sphere's.
    {"sphere", [] { return std::vector{part("sphere", "", makeSphere(65))}; }},
    {"torus-knot", [] { return std::vector{part("torus-knot", "", makeTorusKnot())}; }},
    {"teapot", teapot},
    {"brilliant", [] { return std::vector{part("brilliant", "diamond", makeBrilliant())}; }},
    {"tumbler", tumbler},
    {"water", [] { return std::vector{part("water", "water", makeWaterSurface())}; }},
    {"wine-glass", [] { return std::vector{part("wine-glass", "glass", makeWineGlass())}; }},
    {"cube",
     [] { return std::vector{part("cube", "", makeBox(glm::vec3(-0.7f), glm::vec3(0.7f)))}; }},
};

}  // namespace

std::vector<std::string_view> shapeNames() {
    std::vector<std::string_view> names;
    for (const NamedShape& shape : kShapes) names.push_back(shape.name);
    return names;
}

std::optional<std::vector<ShapePart>> makeShape(std::string_view name) {
    for (const NamedShape& shape : kShapes)
        if (shape.name == name) return shape.make();
    return std::nullopt;
}

}  // namespace tukor
