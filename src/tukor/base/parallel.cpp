#include "tukor/base/parallel.h"

#include <algorithm>
#include <memory>

#ifdef __SANITIZE_THREAD__
#include <atomic>
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

#ifdef __SANITIZE_THREAD__

// ThreadSanitizer does not see how TBB synchronises: it is not compiled with it.

namespace {
std::atomic<int> threads = 4;
}

void parallelFor(int begin, int end, int grain, const std::function<void(int, int)>& body) {
    const int step = std::max(grain, 1);
    std::atomic<int> next = begin;
    std::mutex mutex;
    std::exception_ptr error;
    const auto work = [&] {
        try {
            for (int at = next.fetch_add(step); at < end; at = next.fetch_add(step))
                body(at, std::min(at + step, end));
        } catch (...) {
            const std::lock_guard lock(mutex);
            error = std::current_exception();
        }
    };
    std::vector<std::thread> others;
    for (int i = 1; i < threads; ++i) others.emplace_back(work);
    work();
    for (std::thread& other : others) other.join();
    if (error) std::rethrow_exception(error);
}

void setThreadCount(int count) {
    threads = count > 0 ? count : 4;
}

int threadCount() noexcept {
    return threads;
}

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

// Without TBB: WebAssembly, where parallelFor is a template.

void setThreadCount(int) {}

int threadCount() noexcept {
    return 1;
}

#endif

}  // namespace tukor
