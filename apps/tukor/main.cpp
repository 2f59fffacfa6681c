// The `tukor` command: parses, then runs one subcommand.
#include <exception>
#include <new>

#include <fmt/format.h>

#include "command.h"
#include "tukor/app/option_table.h"
#include "tukor/app/version.h"
#include "usage.h"

namespace {

int run(int argc, const char* const* argv) {
    using namespace tukor;
    CLI::App program{"Metal, glass and water in captured light: exact, in a file or in a window.",
                     "tukor"};
    program.formatter(helpFormatter());
    program.set_help_flag("-h,--help", "this text; also of every command");
    program.set_version_flag("--version", "tukor " + versionText(), "the version and the commit");
    program.footer(
        "Examples\n"
        "  tukor render sphere --material glass -o glass.png\n"
        "  tukor view watch.glb --environment loft.exr\n"
        "  tukor materials");
    bool markdown = false;
    program.add_flag("--markdown-options", markdown)->group("");  // for docs/options.md

    Action action;
    addRenderCommand(program, action);
    addViewCommand(program, action);
    addMaterialsCommand(program, action);
    addCompareCommand(program, action);
    addEnvironmentCommand(program, action);

    try {
        const auto arguments = joinedArguments(argc, argv);
        // CLI11 takes them last first
        program.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
    } catch (const CLI::ParseError& end) {
        return reportParseEnd(program, end);
    }
    if (markdown) {
        fmt::print("{}", markdownOfOptions());
        return 0;
    }
    if (!action) {
        fmt::print(stderr, "{}", program.help());
        return kExitUsage;
    }
    return action();
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const std::bad_alloc&) {
        fmt::print(stderr, "tukor: out of memory\n");
    } catch (const std::exception& error) {
        fmt::print(stderr, "tukor: {}\n", error.what());
    }
    return tukor::kExitFailure;
}
