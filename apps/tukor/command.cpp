#include "command.h"

#include <utility>

#include "tukor/geometry/shapes.h"

namespace tukor {

CommandOption textOption(std::string names, std::string& value, std::string usage,
                         std::string help) {
    return {.names = std::move(names),
            .usage = std::move(usage),
            .help = std::move(help),
            .read = [&value](const std::vector<std::string>& texts) { value = texts.back(); }};
}

CommandOption flagOption(std::string names, bool& value, std::string help) {
    return {.names = std::move(names),
            .help = std::move(help),
            .takes = CommandOption::Takes::nothing,
            .read = [&value](const std::vector<std::string>&) { value = true; }};
}

CommandOption required(CommandOption option) {
    option.required = true;
    return option;
}

void addSessionOptions(std::vector<CommandOption>& to, SessionOptions& options) {
    std::vector<std::string>& models = options.subject.models;
    to.push_back({.names = "MODEL",
                  .help = fmt::format(
                      "model files (.gltf .glb .obj .ply .stl and others) and built-in shapes "
                      "({}); several become one scene",
                      fmt::join(shapeNames(), ", ")),
                  .takes = CommandOption::Takes::many,
                  .read = [&models](const std::vector<std::string>& texts) { models = texts; }});
    describeGroups(options,
                   [&](std::string_view heading, auto& group) { addOptions(to, heading, group); });
}

}  // namespace tukor
