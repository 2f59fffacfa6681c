// `tukor view`: the same picture in a window.
#include <memory>

#include "command.h"
#include "option_parser.h"
#include "tukor/base/error.h"
#include "usage.h"
#ifdef TUKOR_VIEWER
#include "view/viewer.h"
#endif

namespace tukor {

void addViewCommand(CLI::App& program, Action& action) {
    auto options = std::make_shared<SessionOptions>();
    options->subject.models.clear();
    CLI::App* command = program.add_subcommand("view", "the same in a window, to turn and change");
    addSessionOptions(*command, *options);
    command->footer(
        "In the window\n"
        "  drag            turn around the model      right or middle drag, Shift+drag   move it\n"
        "  wheel, + and -  nearer, farther            double click   look at that point; beside\n"
        "  arrows          turn                                      the model: all of it\n"
        "  Tab             hide the panel             Home           all of the model\n"
        "  F12             save a picture             Ctrl+C         copy the command that renders "
        "it\n"
        "  Ctrl+Q          close\n"
        "Drop model and environment files on it.\n"
        "\n"
        "Examples\n"
        "  tukor view sphere --material glass\n"
        "  tukor view watch.glb --environment loft.exr --environment-rotation 90");
    command->callback([&action, options] {
        if (options->subject.models.empty()) options->subject.models = {"sphere"};
        action = [options]() -> int {
#ifdef TUKOR_VIEWER
            return runViewer(*options);
#else
            throw Error("this build has no window; configure with -DTUKOR_VIEWER=ON");
#endif
        };
    });
}

}  // namespace tukor
