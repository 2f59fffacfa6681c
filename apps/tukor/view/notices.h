// Messages over the picture that go away by themselves: what failed, what was saved where.
#pragma once
#include <chrono>
#include <deque>
#include <string>

namespace tukor {

class Notices {
public:
    enum class Kind { news, trouble };

    void add(Kind kind, std::string text);

    /// ImGui widgets in the lower left corner; forgets what is old.
    void show();

    /// Until when the picture may rest: seconds to the next change, none when there is no notice.
    [[nodiscard]] double secondsToNextChange() const;

private:
    using Clock = std::chrono::steady_clock;
    struct Notice {
        Kind kind;
        std::string text;
        Clock::time_point end;
    };
    std::deque<Notice> notices_;
};

}  // namespace tukor
