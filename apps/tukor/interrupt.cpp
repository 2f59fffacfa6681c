#include "interrupt.h"

#include <array>
#include <csignal>
#include <cstddef>

namespace tukor {
namespace {

constexpr std::array kSignals{SIGINT, SIGTERM};

volatile std::sig_atomic_t signalled = 0;
std::array<void (*)(int), kSignals.size()> before{};

extern "C" void remember(int signal) {
    signalled = 1;
    std::signal(signal, SIG_DFL);  // the next one is not asked about
}

}  // namespace

InterruptWatch::InterruptWatch() {
    signalled = 0;
    for (std::size_t i = 0; i < kSignals.size(); ++i) {
        before[i] = std::signal(kSignals[i], remember);
        // whoever started the program under nohup or in the background wants it deaf
        if (before[i] == SIG_IGN) std::signal(kSignals[i], SIG_IGN);
    }
}

InterruptWatch::~InterruptWatch() {
    for (std::size_t i = 0; i < kSignals.size(); ++i) std::signal(kSignals[i], before[i]);
}

bool InterruptWatch::interrupted() noexcept {
    return signalled != 0;
}

}  // namespace tukor
