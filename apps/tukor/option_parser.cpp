#include "option_parser.h"

#include <fmt/format.h>

#include "tukor/geometry/shapes.h"

namespace tukor {

void addSessionOptions(CLI::App& command, SessionOptions& options) {
    command
        .add_option(
            "MODEL", options.subject.models,
            fmt::format("model files (.gltf .glb .obj .ply .stl and others) and built-in shapes "
                        "({}); several become one scene",
                        fmt::join(shapeNames(), ", ")))
        ->type_name("");
    describeGroups(options, [&](std::string_view heading, auto& group) {
        addOptions(command, heading, group);
    });
}

}  // namespace tukor
