// Data-parallel loops over all cores: TBB natively, one after the other where there are no threads.
#pragma once
#include <functional>

#include "tukor/base/progress.h"

namespace tukor {

/// Calls `body(begin, end)` on disjoint pieces of [begin, end), each at most `grain` long where
/// there are threads, and waits for all.
///
/// Which thread runs which piece varies; results must not depend on it. An exception in a body is
/// rethrown here.
#if defined(__EMSCRIPTEN__) && !defined(__EMSCRIPTEN_PTHREADS__)
template <class Body>  // no threads, and no wrapping of bodies into functions either
void parallelFor(int begin, int end, int, const Body& body) {
    if (begin < end) body(begin, end);
}
#else
void parallelFor(int begin, int end, int grain, const std::function<void(int, int)>& body);
#endif

/// The same, telling `progress` how far it is. False where it asked to stop: the rest was not
/// visited.
template <class Body>
[[nodiscard]] bool parallelFor(int begin, int end, int grain, const Progress& progress,
                               const Body& body) {
    if (!progress) {
        parallelFor(begin, end, grain, body);
        return true;
    }
    constexpr int kSteps = 40;
    for (int i = 0; i < kSteps; ++i) {
        const auto edge = [&](int step) {
            return begin + static_cast<int>(static_cast<long long>(end - begin) * step / kSteps);
        };
        parallelFor(edge(i), edge(i + 1), grain, body);
        if (!progress(static_cast<float>(i + 1) / kSteps)) return false;
    }
    return true;
}

/// How many threads parallelFor uses from now on; 0 means all cores.
void setThreadCount(int threads);
[[nodiscard]] int threadCount() noexcept;

#ifdef __EMSCRIPTEN_PTHREADS__
/// Pieces of others' loops that the calling thread has done.
[[nodiscard]] int piecesHelped() noexcept;
#endif

}  // namespace tukor
