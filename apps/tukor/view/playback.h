// The animation of the model in the window: its moment, by hand or by the clock.
#pragma once
#include <string>
#include <vector>

#include "tukor/app/session.h"

namespace tukor {

class Playback {
public:
    /// The widgets, where the model moves. Changes land in `wanted`.
    void show(const Session& session, SessionOptions& wanted);
    /// Goes on by so many seconds while it plays.
    void goOn(double seconds, const Session& session, SessionOptions& wanted);
    [[nodiscard]] bool playing() const noexcept { return playing_; }

private:
    void lookAt(const SubjectOptions& subject);

    std::vector<std::string> models_;  // those that the rest is about
    std::string animation_;
    std::vector<std::string> names_;  // of all animations
    double seconds_ = 0.0;            // that the animation takes; 0: nothing moves
    bool playing_ = false;
};

}  // namespace tukor
