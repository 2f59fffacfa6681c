// `tukor render`: a picture into a file.
#include <chrono>
#include <memory>

#include <fmt/format.h>
#include <unistd.h>

#include "command.h"
#include "interrupt.h"
#include "messages.h"
#include "progress_bar.h"
#include "tukor/app/option_table.h"
#include "tukor/app/picture.h"
#include "tukor/app/session.h"

namespace tukor {
namespace {

struct RenderArguments {
    SessionOptions session;
    std::string out;
    bool quiet = false;
    bool printOptions = false;
};

int render(const RenderArguments& arguments) {
    if (arguments.printOptions) {
        fmt::print("{}\n", jsonFromOptions(arguments.session));
        return 0;
    }
    requireWritablePicture(arguments.out, arguments.session);  // before any time is spent
    const Session session(arguments.session, rendererFor(arguments.session) == Renderer::trace
                                                 ? LookUps::panorama
                                                 : LookUps::cube);
    if (!arguments.quiet) {
        for (const std::string& unused : unusedInFile(arguments.out, arguments.session))
            warn(unused);
        for (const std::string& warning : session.warnings()) warn(warning);
    }
    const InterruptWatch watch;
    const auto start = std::chrono::steady_clock::now();
    float finished = 0.0f;
    Rendering rendering;
    {
        ProgressBar bar(arguments.quiet ? ProgressBar::Loudness::quiet
                                        : ProgressBar::Loudness::terminal);
        rendering = renderPicture(session, [&](float fraction, std::uint64_t rays) {
            finished = fraction;
            bar.show(fraction, rays);
            return !InterruptWatch::interrupted();
        });
    }
    savePicture(arguments.out, rendering, session.options());
    if (!arguments.quiet) {
        if (!InterruptWatch::interrupted()) {  // else it is known why it is not what was asked
            for (const std::string& warning : warningsOf(rendering, session))
                warn(fmt::format("{}: {}", arguments.out, warning));
        }
        const std::chrono::duration<double> gone = std::chrono::steady_clock::now() - start;
        if (isatty(STDERR_FILENO) == 1) {
            fmt::print(stderr, "{}: {}\n", arguments.out, summaryOf(rendering, gone.count()));
        }
    }
    if (InterruptWatch::interrupted()) {
        fmt::print(stderr, "tukor: stopped at {:.0f} %; the picture so far is {}\n",
                   100.0f * finished, arguments.out);
        return kExitInterrupted;
    }
    return 0;
}

}  // namespace

Command renderCommand() {
    auto arguments = std::make_shared<RenderArguments>();
    Command command{
        .name = "render",
        .help = "a picture of models into a file",
        .footer =
            "Examples\n"
            "  tukor render sphere --material glass --environment sky -o glass.png\n"
            "  tukor render ring.glb --material 'stone*=diamond' --material 'band=gold' -o "
            "ring.jpg\n"
            "  tukor render torus-knot --eye -1,0,4 --fov 30 --size 640x360 --samples 64 -o "
            "knot.exr\n"
            "  tukor render sphere --fidelity single -o textbook.png   (one reflection, one "
            "refraction)",
        .check =
            [arguments] {
                if (arguments->session.subject.models.empty())
                    throw Error("MODEL: is missing; a file or a built-in shape expected");
                if (arguments->out.empty() && !arguments->printOptions)
                    throw Error("-o OUT: is missing; where should the picture go?");
            },
        .run = [arguments] { return render(*arguments); }};
    addSessionOptions(command.options, arguments->session);
    for (CommandOption& option :
         std::vector{textOption("-o,--output", arguments->out, "OUT",
                                ".png or .jpg (tone mapped, sRGB), .exr or .hdr (linear radiance)"),
                     flagOption("--quiet", arguments->quiet, "no progress and no warnings"),
                     flagOption("--print-options", arguments->printOptions,
                                "print every option as JSON and render nothing")}) {
        option.heading = "Output";
        command.options.push_back(std::move(option));
    }
    return command;
}

}  // namespace tukor
