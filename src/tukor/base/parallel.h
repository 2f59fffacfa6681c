// Data-parallel loops over all cores: TBB natively, one after the other where there are no threads.
#pragma once
#include <functional>

namespace tukor {

/// Calls `body(begin, end)` on disjoint pieces of [begin, end), each at most `grain` long where
/// there are threads, and
/// waits for all.
///
/// Which thread runs which piece varies; results must not depend on it. An exception in a body is
/// rethrown here.
#ifdef __EMSCRIPTEN__
template <class Body>  // no threads, and no wrapping of bodies into functions either
void parallelFor(int begin, int end, int, const Body& body) {
    if (begin < end) body(begin, end);
}
#else
void parallelFor(int begin, int end, int grain, const std::function<void(int, int)>& body);
#endif

/// How many threads parallelFor uses from now on; 0 means all cores.
void setThreadCount(int threads);
[[nodiscard]] int threadCount() noexcept;

}  // namespace tukor
