#include "option_parser.h"

namespace tukor {

void addSessionOptions(CLI::App& command, SessionOptions& options) {
    command
        .add_option(
            "MODEL", options.subject.models,
            "model files (.gltf .glb .obj .ply .stl and others) and built-in shapes: sphere "
            "torus-knot teapot brilliant tumbler water; several become one scene")
        ->type_name("");
    describeGroups(options, [&](std::string_view heading, auto& group) {
        addOptions(command, heading, group);
    });
}

}  // namespace tukor
