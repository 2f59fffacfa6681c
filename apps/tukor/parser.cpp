#include "parser.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <sstream>
#include <utility>

// All of it is headers, half a minute to compile: this is the only file that includes it.
#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "messages.h"
#include "tukor/app/suggestion.h"
#include "tukor/app/version.h"
#include "tukor/base/spelling.h"

namespace tukor {
namespace {

constexpr std::size_t kNameColumns = 34;
constexpr std::size_t kColumns = 100;

/// Words of `text` in lines of the right column; the first line goes on where the name ended.
std::string wrapped(const std::string& text) {
    std::string out;
    std::size_t column = kNameColumns;
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        if (column > kNameColumns && column + 1 + word.size() > kColumns) {
            out += "\n" + std::string(kNameColumns, ' ');
            column = kNameColumns;
        } else if (column > kNameColumns) {
            out += ' ';
            ++column;
        }
        out += word;
        column += word.size();
    }
    return out + "\n";
}

class HelpFormatter : public CLI::Formatter {
public:
    std::string make_option(const CLI::Option* option, bool isPositional) const override {
        std::string name = "  ";
        for (const char c : option->get_name(isPositional, !isPositional)) {
            name += c;
            if (c == ',') name += ' ';
        }
        if (!isPositional && !option->get_type_name().empty()) {
            name += " " + option->get_type_name();
        }
        std::string help = option->get_description();
        if (!option->get_default_str().empty()) {
            help += fmt::format(" (default {})", option->get_default_str());
        }
        if (name.size() + 2 > kNameColumns) {
            name += "\n" + std::string(kNameColumns, ' ');
        } else {
            name.resize(kNameColumns, ' ');
        }
        return name + wrapped(help);
    }

    std::string make_subcommand(const CLI::App* command) const override {
        std::string name = "  " + command->get_name();
        name.resize(16, ' ');
        return name + command->get_description() + "\n";
    }

    std::string make_usage(const CLI::App* command, std::string name) const override {
        std::string usage = "Usage: " + name;
        if (!command->get_subcommands({}).empty()) return usage + " COMMAND [options]\n\n";
        for (const CLI::Option* option : command->get_options()) {
            if (option->get_positional()) usage += " " + option->get_name(true);
            if (option->get_positional() && option->get_expected_max() > 1) usage += "...";
        }
        usage += " [options]";
        if (command->get_option_no_throw("--output") != nullptr) usage += " -o OUT";
        return usage + "\n\n";
    }

    /// The library's page with no more than one empty line in a row.
    std::string make_help(const CLI::App* command, std::string name,
                          CLI::AppFormatMode mode) const override {
        std::string page = CLI::Formatter::make_help(command, std::move(name), mode);
        for (auto gap = page.find("\n\n\n"); gap != page.npos; gap = page.find("\n\n\n")) {
            page.erase(gap, 1);
        }
        return page;
    }

    std::string make_footer(const CLI::App* command) const override {
        const std::string footer = command->get_footer();
        return footer.empty() ? "" : "\n" + footer + "\n";
    }
};

/// The subcommand that was being parsed, or the program itself.
const CLI::App& parsedCommand(const CLI::App& program) {
    const CLI::App* command = &program;
    for (auto parsed = command->get_subcommands(); !parsed.empty();
         parsed = command->get_subcommands()) {
        command = parsed.front();
    }
    return *command;
}

std::string commandName(const CLI::App& command) {
    std::string name = command.get_name();
    for (const CLI::App* parent = command.get_parent(); parent; parent = parent->get_parent()) {
        name = fmt::format("{} {}", parent->get_name(), name);
    }
    return name;
}

/// About the first argument that nothing took; empty when there is none.
std::string aboutLeftovers(const CLI::App& program, const CLI::App& command) {
    for (const std::string& argument : program.remaining(true)) {
        if (argument.size() > 1 && argument.starts_with('-')) {
            const std::string given = argument.substr(0, argument.find('='));
            std::vector<std::string_view> known;
            for (const CLI::Option* option : command.get_options())
                known.insert(known.end(), option->get_lnames().begin(), option->get_lnames().end());
            // without the dashes, which would make half of a short name right
            const auto start = std::min(given.find_first_not_of('-'), given.size());
            const std::string_view nearest = nearestName(given.substr(start), known);
            return fmt::format("unknown option {}{}", given,
                               nearest.empty() ? "" : fmt::format("; did you mean --{}?", nearest));
        }
        std::vector<std::string> names;
        for (const CLI::App* sub : command.get_subcommands({})) {
            if (!sub->get_group().empty()) names.push_back(sub->get_name());
        }
        if (names.empty()) return fmt::format("unexpected argument '{}'", argument);
        const std::vector<std::string_view> known(names.begin(), names.end());
        return fmt::format("command {}", unknownName(argument, known));
    }
    return {};
}

int reportParseEnd(const CLI::App& program, const CLI::ParseError& end) {
    if (end.get_exit_code() == 0) return program.exit(end);  // --help, --version: on stdout
    const CLI::App& command = parsedCommand(program);
    std::string message = aboutLeftovers(program, command);
    if (message.empty()) message = end.what();
    fmt::print(stderr, "tukor: {}\nTry `{} --help`.\n", message, commandName(command));
    return kExitUsage;
}

/// Arguments as the library takes them: a value like -.5,0,1 after an option is joined to it by
/// '='.
std::vector<std::string> joinedArguments(int argc, const char* const* argv) {
    std::vector<std::string> arguments;
    for (int i = 1; i < argc; ++i) {
        const std::string argument = argv[i];
        const bool isNumber = argument.size() > 1 && argument[0] == '-' &&
                              (argument[1] == '.' || (argument[1] >= '0' && argument[1] <= '9'));
        if (isNumber && !arguments.empty() && arguments.back().starts_with("--") &&
            arguments.back().find('=') == std::string::npos) {
            arguments.back() += "=" + argument;
        } else {
            arguments.push_back(argument);
        }
    }
    return arguments;
}

void addOption(CLI::App& app, const CommandOption& option) {
    const bool isPositional = !option.names.starts_with('-');
    const auto read = [&option](const std::vector<std::string>& texts) {
        try {
            option.read(texts);
        } catch (const Error& error) {
            throw CLI::ValidationError(option.names, error.what());
        }
    };
    CLI::Option* added = nullptr;
    if (option.takes == CommandOption::Takes::nothing) {
        added = app.add_flag_callback(
            option.names, [read] { read({}); }, option.help);
    } else if (isPositional && option.takes == CommandOption::Takes::one) {
        added = app.add_option_function<std::string>(
            option.names, [read](const std::string& text) { read({text}); }, option.help);
    } else {
        added = app.add_option_function<std::vector<std::string>>(option.names, read, option.help);
    }
    if (!isPositional && option.takes == CommandOption::Takes::one) added->allow_extra_args(false);
    if (option.takes != CommandOption::Takes::nothing) added->type_name(option.usage);
    added->default_str(option.defaultText)->required(option.required);
    if (!option.heading.empty()) added->group(option.heading);
}

/// `chosen` becomes the innermost command that the arguments name.
void addCommand(CLI::App& app, const Command& command, const Command*& chosen) {
    for (const CommandOption& option : command.options) addOption(app, option);
    for (const Command& child : command.commands) {
        CLI::App* added = app.add_subcommand(child.name, child.help);
        if (child.isHidden) added->group("");
        addCommand(*added, child, chosen);
    }
    app.footer(command.footer);
    if (!command.run) return;  // one of its commands must follow
    app.callback([&] {
        try {
            if (command.check) command.check();
        } catch (const Error& error) {
            throw CLI::ValidationError(error.what(), CLI::ExitCodes::ValidationError);
        }
        chosen = &command;
    });
}

}  // namespace

int runCommandLine(const Command& program, int argc, const char* const* argv) {
    CLI::App app{program.help, program.name};
    app.formatter(std::make_shared<HelpFormatter>());
    app.set_help_flag("-h,--help", "this text; also of every command");
    app.set_version_flag("--version", fmt::format("{} {}", program.name, versionText()),
                         "the version and the commit");
    const Command* chosen = nullptr;
    addCommand(app, program, chosen);
    try {
        const auto arguments = joinedArguments(argc, argv);
        // CLI11 takes them last first
        app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
    } catch (const CLI::ParseError& end) {
        return reportParseEnd(app, end);
    }
    if (chosen == nullptr) {
        fmt::print(stderr, "{}", app.help());
        return kExitUsage;
    }
    return chosen->run();
}

}  // namespace tukor
