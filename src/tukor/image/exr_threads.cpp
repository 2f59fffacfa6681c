#include <algorithm>
#include <mutex>

#include <OpenEXR/ImfThreading.h>

#include "tukor/base/parallel.h"
#include "tukor/image/exr_file.h"

namespace tukor {

void startExrThreads() {
    static std::once_flag once;
    std::call_once(once, [] {
        // The library keeps two chunks for each thread, of up to 256 MB each: not one per core.
        constexpr int kMostThreads = 4;
        const int threads = std::min(threadCount(), kMostThreads);
        Imf::setGlobalThreadCount(threads > 1 ? threads : 0);
    });
}

}  // namespace tukor
