#include "interrupt.h"

#include <csignal>

namespace tukor {
namespace {

volatile std::sig_atomic_t signalled = 0;

extern "C" void remember(int signal) {
    signalled = 1;
    std::signal(signal, SIG_DFL);  // the next one is not asked about
}

}  // namespace

InterruptWatch::InterruptWatch() {
    signalled = 0;
    std::signal(SIGINT, remember);
    std::signal(SIGTERM, remember);
}

InterruptWatch::~InterruptWatch() {
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
}

bool InterruptWatch::interrupted() noexcept {
    return signalled != 0;
}

}  // namespace tukor
