// Ctrl-C as a request: the first one asks the work to stop, the second one ends the program.
#pragma once

namespace tukor {

/// While it lives, the first SIGINT or SIGTERM is remembered instead of ending the program,
/// unless it was ignored. One at a time.
class InterruptWatch {
public:
    InterruptWatch();
    ~InterruptWatch();
    InterruptWatch(const InterruptWatch&) = delete;
    InterruptWatch& operator=(const InterruptWatch&) = delete;

    [[nodiscard]] static bool interrupted() noexcept;
};

}  // namespace tukor
