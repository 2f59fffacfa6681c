#include "tukor/base/parallel.h"

#include <algorithm>
#include <memory>

#if defined(__SANITIZE_THREAD__) || defined(__EMSCRIPTEN_PTHREADS__)
#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>
#elif defined(TUKOR_HAS_TBB)
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#endif

namespace tukor {

#if defined(__SANITIZE_THREAD__) || defined(__EMSCRIPTEN_PTHREADS__)

// Helpers of our own: WebAssembly has no TBB, and ThreadSanitizer does not see how TBB
// synchronises. Who asks for a loop works on it too, and never waits for a helper to begin: in a
// browser one may never.

namespace {

struct Loop {
    std::atomic<int> next;
    const int end, step;
    const std::function<void(int, int)>& body;
    int helpers = 0;  // in it now; this and `error` under the crew's mutex
    std::exception_ptr error;
};

struct Crew {
    std::mutex mutex;
    std::condition_variable called, left;
    std::vector<Loop*> loops;  // that have pieces left, the innermost last
    int wanted = 1;            // threads, with the caller
    int helpers = 0;
};

Crew& crew() {
    static Crew& only = *new Crew;  // helpers may outlive main()
    return only;
}

// How many pieces it did.
int work(Loop& loop) {
    int at, pieces = 0;
    try {
        for (; (at = loop.next.fetch_add(loop.step)) < loop.end; ++pieces)
            loop.body(at, std::min(at + loop.step, loop.end));
    } catch (...) {
        const std::lock_guard lock(crew().mutex);
        loop.error = std::current_exception();
    }
    const std::lock_guard lock(crew().mutex);
    std::erase(crew().loops, &loop);
    return pieces;
}

thread_local int helped = 0;

void help() {
    Crew& c = crew();
    std::unique_lock lock(c.mutex);
    for (;;) {
        c.called.wait(lock, [&] { return !c.loops.empty() || c.helpers >= c.wanted; });
        if (c.helpers >= c.wanted) break;
        Loop& loop = *c.loops.back();
        ++loop.helpers;
        lock.unlock();
        helped += work(loop);
        lock.lock();
        if (--loop.helpers == 0) c.left.notify_all();
    }
    --c.helpers;
}

#ifdef __SANITIZE_THREAD__
const bool hired = (setThreadCount(0), true);
#endif

}  // namespace

void parallelFor(int begin, int end, int grain, const std::function<void(int, int)>& body) {
    if (begin >= end) return;
    Crew& c = crew();
    Loop loop{begin, end, std::max(grain, 1), body, 0, nullptr};
    std::unique_lock lock(c.mutex);
    c.loops.push_back(&loop);
    lock.unlock();
    c.called.notify_all();
    work(loop);
    lock.lock();
    c.left.wait(lock, [&] { return loop.helpers == 0; });
    if (loop.error) std::rethrow_exception(loop.error);
}

void setThreadCount(int threads) {
    constexpr int kAll = 4;
    Crew& c = crew();
    const std::lock_guard lock(c.mutex);
    c.wanted = threads > 0 ? threads : kAll;
    for (; c.helpers < c.wanted - 1; ++c.helpers) std::thread(help).detach();
    c.called.notify_all();
}

int threadCount() noexcept {
    Crew& c = crew();
    const std::lock_guard lock(c.mutex);
    return c.wanted;
}

#ifdef __EMSCRIPTEN_PTHREADS__
int piecesHelped() noexcept {
    return helped;
}
#endif

#elif defined(TUKOR_HAS_TBB)

namespace {
std::unique_ptr<tbb::global_control> limit;
}

void parallelFor(int begin, int end, int grain, const std::function<void(int, int)>& body) {
    if (begin >= end) return;
    const auto step = static_cast<std::size_t>(std::max(grain, 1));
    tbb::parallel_for(
        tbb::blocked_range<int>(begin, end, step),
        [&](const tbb::blocked_range<int>& piece) { body(piece.begin(), piece.end()); },
        tbb::simple_partitioner());
}

void setThreadCount(int threads) {
    limit.reset();
    if (threads > 0)
        limit = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                      static_cast<std::size_t>(threads));
}

int threadCount() noexcept {
    return static_cast<int>(
        tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
}

#else

// WebAssembly without threads, where parallelFor is a template.

void setThreadCount(int) {}

int threadCount() noexcept {
    return 1;
}

#endif

}  // namespace tukor
