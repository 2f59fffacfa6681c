// The subcommands as data: what each is called, takes and does. parser.cpp makes a command line of
// them.
#pragma once
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "tukor/app/option_text.h"

namespace tukor {

/// An option, or a positional argument.
struct CommandOption {
    enum class Takes { nothing, one, many };  // many: given again, or one after the other

    std::string names = {};  // `--quiet`, `-o,--output`; a positional has no dashes: `MODEL`
    std::string usage = {};  // what stands for the value
    std::string help = {};
    std::string heading = {};  // of its section of --help
    std::string defaultText = {};
    Takes takes = Takes::one;
    bool required = false;
    /// The texts given for it, in their order. Throws Error without the option's name.
    std::function<void(const std::vector<std::string>&)> read = {};
};

struct Command {
    std::string name = {};
    std::string help = {};    // one line
    std::string footer = {};  // of its --help
    std::vector<CommandOption> options = {};
    std::vector<Command> commands = {};  // of which one must follow
    bool isHidden = false;               // from the help
    /// After parsing, before any work: throws Error about what is missing; may be empty.
    std::function<void()> check = {};
    /// The work; returns the exit status. Empty where a command must follow. Owns what the options
    /// were read into.
    std::function<int()> run = {};
};

[[nodiscard]] Command renderCommand();
[[nodiscard]] Command viewCommand();
[[nodiscard]] Command materialsCommand();
[[nodiscard]] Command compareCommand();
[[nodiscard]] Command environmentCommand();

/// A text, and a switch.
[[nodiscard]] CommandOption textOption(std::string names, std::string& value, std::string usage,
                                       std::string help);
[[nodiscard]] CommandOption flagOption(std::string names, bool& value, std::string help);
[[nodiscard]] CommandOption required(CommandOption option);

/// An option for every row of the struct's table, into `to`; values land in `options`, which must
/// outlive the parsing. A flag given twice takes the later value; lists grow.
template <class Options>
void addOptions(std::vector<CommandOption>& to, std::string_view heading, Options& options) {
    describe(
        options, [&](std::string_view name, auto& value, const auto& extra, std::string_view help) {
            const auto read = [&value, extra](const std::vector<std::string>& texts) {
                for (const std::string& text : texts) assignFromText(value, extra, text);
            };
            to.push_back(
                {.names = fmt::format("--{}", name),
                 .usage = usageOf(extra),
                 .help = std::string(help),
                 .heading = std::string(heading),
                 .defaultText = fmt::format("{}", fmt::join(textsFromOption(value, extra), ", ")),
                 .read = read});
        });
}

/// MODEL..., and the options of every group.
void addSessionOptions(std::vector<CommandOption>& to, SessionOptions& options);

}  // namespace tukor
