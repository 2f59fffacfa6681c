// `tukor render`: a picture into a file.
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include <fmt/format.h>
#include <unistd.h>

#include "command.h"
#include "interrupt.h"
#include "messages.h"
#include "progress_bar.h"
#include "tukor/app/option_table.h"
#include "tukor/app/picture.h"
#include "tukor/app/series.h"
#include "tukor/app/session.h"

namespace tukor {
namespace {

struct RenderArguments {
    SessionOptions session;
    SeriesOptions series;
    std::string out;
    bool quiet = false;
    bool printOptions = false;
};

/// Says each thing once, whatever the figures and however many pictures it is true of.
class Warnings {
public:
    explicit Warnings(bool quiet) : quiet_(quiet) {}
    void say(const std::string& text, const std::filesystem::path& out = {}) {
        std::string what = text;
        std::erase_if(what, [](char c) { return c >= '0' && c <= '9'; });
        if (quiet_ || !said_.insert(what).second) return;
        warn(out.empty() ? text : fmt::format("{}: {}", out.string(), text));
    }

private:
    bool quiet_;
    std::set<std::string> said_;
};

int render(const RenderArguments& arguments) {
    if (arguments.printOptions) {
        fmt::print("{}\n", jsonFromOptions(arguments.session));
        return 0;
    }
    const Series series(arguments.series, arguments.session);
    const auto pathOf = [&](int index) {
        return series.several() ? numberedPath(arguments.out, index + 1)
                                : std::filesystem::path(arguments.out);
    };
    // before any time is spent
    requireWritablePicture(pathOf(0), arguments.session);
    Session session(series.first(), rendererFor(arguments.session) == Renderer::trace
                                        ? LookUps::panorama
                                        : LookUps::cube);
    Warnings warnings(arguments.quiet);
    for (const std::string& unused : unusedInFile(arguments.out, arguments.session))
        warnings.say(unused);
    for (const std::string& warning : session.warnings()) warnings.say(warning);
    const InterruptWatch watch;
    const Camera camera = session.camera();
    const std::optional<float> ground = session.renderOptions().ground;
    const int count = series.count();
    for (int i = 0; i < count; ++i) {
        const auto start = std::chrono::steady_clock::now();
        const std::string out = pathOf(i).string();
        session.apply(series.optionsOf(i, camera, ground));
        float finished = 0.0f;
        Rendering rendering;
        {
            ProgressBar bar(arguments.quiet ? ProgressBar::Loudness::quiet
                                            : ProgressBar::Loudness::terminal);
            rendering = renderPicture(
                session,
                [&](float fraction, std::uint64_t rays) {
                    finished = fraction;
                    bar.show((static_cast<float>(i) + fraction) / static_cast<float>(count), rays);
                    return !InterruptWatch::interrupted();
                },
                showsBeyondWhite(out, session.options()));
        }
        if (InterruptWatch::interrupted() && count > 1) {  // one of a series is whole or not there
            fmt::print(stderr, "tukor: stopped after {} of {} pictures\n", i, count);
            return kExitInterrupted;
        }
        savePicture(out, rendering, session.options());
        const std::string clipped = clippedInFile(out, rendering, session.options());
        if (!clipped.empty()) warnings.say(clipped, out);
        if (InterruptWatch::interrupted()) {  // it is known why it is not what was asked
            fmt::print(stderr, "tukor: stopped at {:.0f} %; the picture so far is {}\n",
                       100.0f * finished, out);
            return kExitInterrupted;
        }
        for (const std::string& warning : warningsOf(rendering, session))
            warnings.say(warning, out);
        const std::chrono::duration<double> gone = std::chrono::steady_clock::now() - start;
        if (!arguments.quiet && isatty(STDERR_FILENO) == 1)
            fmt::print(stderr, "{}: {}\n", out, summaryOf(rendering, gone.count()));
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
            "  tukor render teapot --material gold+rough:0.3 --environment loft.exr -o satin.png\n"
            "  tukor render torus-knot --eye -1,0,4 --fov 30 --size 640x360 --samples 64 -o "
            "knot.exr\n"
            "  tukor render ring.stl --model-up z --model-scale 0.001 --turntable 48 -o "
            "turn-####.png\n"
            "  tukor render watch.glb --fps 25 --eye 0,0.1,0.3 -o film/tick-####.png\n"
            "  tukor render ring.glb --aperture 0.01 --focus 0.2 --error 0.5 -o macro.png\n"
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
    addOptions(command.options, "Output", arguments->series);
    return command;
}

}  // namespace tukor
