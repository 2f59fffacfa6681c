// Writes a built-in shape as a Wavefront OBJ, so that peers can render the same triangles.
//
// usage: export_shape NAME OUT.obj [X Y Z]     moved by X Y Z metres; a part is named as the file
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iterator>
#include <string>

#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/base/file.h"
#include "tukor/geometry/shapes.h"

namespace {

std::string objFromShape(const std::vector<tukor::ShapePart>& parts, glm::vec3 offset,
                         const std::string& name) {
    std::string text;
    auto out = std::back_inserter(text);
    unsigned base = 1;
    for (const tukor::ShapePart& part : parts) {
        fmt::format_to(out, "o {}\n", parts.size() == 1 ? name : part.name);
        for (glm::vec3 p : part.mesh.positions)
            fmt::format_to(out, "v {} {} {}\n", p.x + offset.x, p.y + offset.y, p.z + offset.z);
        for (glm::vec3 n : part.mesh.normals) fmt::format_to(out, "vn {} {} {}\n", n.x, n.y, n.z);
        for (glm::uvec3 t : part.mesh.triangles)
            fmt::format_to(out, "f {0}//{0} {1}//{1} {2}//{2}\n", t.x + base, t.y + base,
                           t.z + base);
        base += static_cast<unsigned>(part.mesh.positions.size());
    }
    return text;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        if (argc != 3 && argc != 6) {
            std::fprintf(stderr, "usage: export_shape NAME OUT.obj [X Y Z]\n");
            return 2;
        }
        const auto parts = tukor::makeShape(argv[1]);
        if (!parts) throw tukor::Error(fmt::format("{}: no such shape", argv[1]));
        glm::vec3 offset(0.0f);
        for (int axis = 0; argc == 6 && axis < 3; ++axis) offset[axis] = std::stof(argv[3 + axis]);
        const std::filesystem::path out = argv[2];
        tukor::writeFile(out, objFromShape(*parts, offset, out.stem().string()));
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "export_shape: %s\n", error.what());
        return 1;
    }
}
