// `tukor view`: the same picture in a window.
#include <memory>

#include "command.h"
#include "tukor/base/error.h"
#ifdef TUKOR_VIEWER
#include "view/viewer.h"
#endif

namespace tukor {

Command viewCommand() {
    auto options = std::make_shared<SessionOptions>();
    options->subject.models.clear();
    Command command{
        .name = "view",
        .help = "the same in a window, to turn and change",
        .footer =
            "In the window\n"
            "  drag            turn around the model      right or middle drag, Shift+drag   move "
            "it\n"
            "  wheel, + and -  nearer, farther            double click   look at that point; "
            "beside\n"
            "  arrows          turn                                      the model: all of it\n"
            "  Tab             hide the panel             Home           all of the model\n"
            "  F12             save a picture             Ctrl+C         copy the command that "
            "renders "
            "it\n"
            "  Ctrl+Q          close\n"
            "Drop model and environment files on it.\n"
            "\n"
            "Examples\n"
            "  tukor view sphere --material glass\n"
            "  tukor view watch.glb --environment loft.exr --environment-rotation 90",
        .run = [options]() -> int {
            if (options->subject.models.empty()) options->subject.models = {"sphere"};
#ifdef TUKOR_VIEWER
            return runViewer(*options);
#else
            throw Error("this build has no window; configure with -DTUKOR_VIEWER=ON");
#endif
        }};
    addSessionOptions(command.options, *options);
    return command;
}

}  // namespace tukor
