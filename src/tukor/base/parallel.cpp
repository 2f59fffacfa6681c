#include "tukor/base/parallel.h"

#include <algorithm>
#include <memory>

#ifdef TUKOR_HAS_TBB
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#endif

namespace tukor {

#ifdef TUKOR_HAS_TBB

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
