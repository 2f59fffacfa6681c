// How far a picture is, on one line of a terminal.
#pragma once
#include <chrono>
#include <cstdint>
#include <string>

namespace tukor {

/// Draws on stderr when that is a terminal and `loudness` allows; silent otherwise. Erases itself.
class ProgressBar {
public:
    enum class Loudness { terminal, quiet };

    explicit ProgressBar(Loudness loudness);
    ~ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    /// At most ten times a second; `fraction` in [0, 1]; `rays` so far where there are any.
    void show(float fraction, std::uint64_t rays = 0);

private:
    using Clock = std::chrono::steady_clock;
    bool visible_;
    bool drawn_ = false;
    Clock::time_point started_ = Clock::now();
    Clock::time_point shown_{};
};

/// ` 42 %  [########            ]  3.1 million rays a second  0:12 left`; without the time while it
/// cannot be told.
[[nodiscard]] std::string progressLine(float fraction, double secondsGone, std::uint64_t rays);

}  // namespace tukor
