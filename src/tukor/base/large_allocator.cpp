#include "tukor/base/large_allocator.h"

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace tukor {

namespace {

constexpr std::size_t kLargePage = std::size_t{2} << 20;
constexpr std::size_t kLarge = 2 * kLargePage;  // below, aligning would waste too much

}  // namespace

void* allocateLarge(std::size_t bytes) {
    if (bytes < kLarge) return ::operator new(bytes);
    void* const memory = ::operator new (bytes, std::align_val_t{kLargePage});
#if defined(__linux__) && defined(MADV_HUGEPAGE)
    // Whole pages only: the last one would count as used although little of it is. Only advice:
    // where it is not taken, all works as before.
    (void)madvise(memory, bytes / kLargePage * kLargePage, MADV_HUGEPAGE);
#endif
    return memory;
}

void freeLarge(void* memory, std::size_t bytes) noexcept {
    if (bytes < kLarge)
        ::operator delete(memory);
    else
        ::operator delete (memory, std::align_val_t{kLargePage});
}

}  // namespace tukor
