#include "tukor/gl/render.h"

#include <algorithm>

#include "tukor/gl/context.h"
#include "tukor/gl/renderer.h"

namespace tukor::gl {

namespace {

// Two multisampled frames: within 1.8/255 of the limit on spheres under photographs; one is 2.7
// off.
constexpr int kDefaultSamples = 8;
// Within every driver's limit on framebuffers, and 200 MB of them.
constexpr int kLargestWindow = 2048;

void copyInto(Rendering& whole, const Rendering& part, const PictureWindow& window) {
    const int top = window.fullHeight - window.bottom - window.height;
    for (int row = 0; row < window.height; ++row) {
        for (int column = 0; column < window.width; ++column) {
            whole.radiance.at(window.left + column, top + row) = part.radiance.at(column, row);
            if (part.radiance.alpha.empty()) continue;
            const auto from = static_cast<std::size_t>(row) * window.width + column;
            const auto to = static_cast<std::size_t>(top + row) * window.fullWidth + window.left +
                            static_cast<std::size_t>(column);
            whole.radiance.alpha[to] = part.radiance.alpha[from];
        }
    }
}

}  // namespace

Rendering render(const Scene& scene, const Environment& environment, const Camera& camera,
                 const RenderOptions& options, const RenderProgress& progress) {
    const Context context;
    Renderer renderer;
    const bool single = options.fidelity == Fidelity::single;
    const Preparation preparation = single ? Preparation::single : Preparation::all;
    renderer.setScene(scene, preparation);
    renderer.setEnvironment(environment, preparation);
    renderer.setCounting(single ? Counting::none : Counting::all);
    FrameOptions frame;
    frame.picture = options;
    const int samples = options.samples.value_or(kDefaultSamples);
    frame.picture.samples = samples;

    std::vector<PictureWindow> windows;
    for (int bottom = 0; bottom < options.height; bottom += kLargestWindow)
        for (int left = 0; left < options.width; left += kLargestWindow)
            windows.push_back({options.width, options.height, left, bottom,
                               std::min(kLargestWindow, options.width - left),
                               std::min(kLargestWindow, options.height - bottom)});

    Rendering whole;
    bool stopped = false;
    for (std::size_t i = 0; i < windows.size(); ++i) {
        do {
            renderer.drawFrame(camera, frame, windows[i]);
            const float share = std::min(1.0f, static_cast<float>(renderer.accumulatedSamples()) /
                                                   static_cast<float>(samples));
            if (progress)
                stopped =
                    !progress((static_cast<float>(i) + share) / static_cast<float>(windows.size()),
                              0) ||
                    stopped;
        } while (!stopped && renderer.accumulatedSamples() < samples);
        Rendering part = renderer.read();
        if (windows.size() == 1) return part;
        if (i == 0) {
            whole.radiance = Image(options.width, options.height);
            if (options.background == Background::none)
                whole.radiance.alpha.resize(whole.radiance.pixels().size());
        }
        copyInto(whole, part, windows[i]);
        whole.rays += part.rays;
        whole.leaks += part.leaks;
        whole.inconsistencies += part.inconsistencies;
        whole.truncated += part.truncated;
        if (stopped) break;
    }
    return whole;
}

}  // namespace tukor::gl
