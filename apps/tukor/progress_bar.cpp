#include "progress_bar.h"

#include <algorithm>
#include <cstdio>

#include <fmt/format.h>
#include <unistd.h>

namespace tukor {

ProgressBar::ProgressBar(Loudness loudness)
    : visible_(loudness == Loudness::terminal && isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() {
    if (drawn_) fmt::print(stderr, "\r\x1b[K");
}

void ProgressBar::show(float fraction, std::uint64_t rays) {
    if (!visible_) return;
    const auto now = Clock::now();
    if (now - shown_ < std::chrono::milliseconds(100)) return;
    shown_ = now;
    drawn_ = true;
    const std::chrono::duration<double> gone = now - started_;
    fmt::print(stderr, "\r{}\x1b[K", progressLine(fraction, gone.count(), rays));
    std::fflush(stderr);
}

std::string progressLine(float fraction, double secondsGone, std::uint64_t rays) {
    constexpr int kCells = 30;
    const float finished = std::clamp(fraction, 0.0f, 1.0f);
    const int full = static_cast<int>(finished * kCells);
    std::string line = fmt::format("{:3.0f} %  [{:<{}}]", 100.0f * finished,
                                   std::string(static_cast<std::size_t>(full), '#'), kCells);
    if (rays > 0 && secondsGone > 0.1)
        line += fmt::format("  {:.1f} million rays a second",
                            1e-6 * static_cast<double>(rays) / secondsGone);
    if (finished > 0.01f && secondsGone > 0.5) {
        const long left = static_cast<long>(secondsGone * (1.0 / finished - 1.0) + 0.5);
        line += left < 3600
                    ? fmt::format("  {}:{:02} left", left / 60, left % 60)
                    : fmt::format("  {}:{:02}:{:02} left", left / 3600, left / 60 % 60, left % 60);
    }
    return line;
}

}  // namespace tukor
