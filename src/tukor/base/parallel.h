// Data-parallel loops over all cores: TBB natively, one after the other where there are no threads.
#pragma once
#include <functional>

namespace tukor {

/// Calls `body(begin, end)` on disjoint pieces of [begin, end), each at most `grain` long, and
/// waits for all.
///
/// Which thread runs which piece varies; results must not depend on it. An exception in a body is
/// rethrown here.
void parallelFor(int begin, int end, int grain, const std::function<void(int, int)>& body);

/// How many threads parallelFor uses from now on; 0 means all cores.
void setThreadCount(int threads);
[[nodiscard]] int threadCount() noexcept;

}  // namespace tukor
