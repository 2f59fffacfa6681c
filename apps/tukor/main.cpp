// The `tukor` command: its subcommands, and what ends them all.
#include <exception>
#include <new>

#include <fmt/format.h>

#include "messages.h"
#include "parser.h"
#include "tukor/app/option_table.h"

namespace {

tukor::Command program() {
    using namespace tukor;
    return {.name = "tukor",
            .help = "Metal, glass and water in captured light: exact, in a file or in a window.",
            .footer =
                "Examples\n"
                "  tukor render sphere --material glass -o glass.png\n"
                "  tukor view watch.glb --environment loft.exr\n"
                "  tukor materials",
            .commands = {renderCommand(),
                         viewCommand(),
                         materialsCommand(),
                         compareCommand(),
                         environmentCommand(),
                         {.name = "markdown-options",  // docs/options.md
                          .isHidden = true,
                          .run = [] {
                              fmt::print("{}", markdownOfOptions());
                              return 0;
                          }}}};
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return tukor::runCommandLine(program(), argc, argv);
    } catch (const std::bad_alloc&) {
        fmt::print(stderr, "tukor: out of memory\n");
    } catch (const std::exception& error) {
        fmt::print(stderr, "tukor: {}\n", error.what());
    }
    return tukor::kExitFailure;
}
