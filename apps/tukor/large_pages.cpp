// Large blocks of memory on large pages: a start of `tukor render` spends a quarter of its time on
// the faults of small ones.
//
// Replaces the command's operator new. Not under sanitizers, which bring their own.
#include <cstdint>  // brings __GLIBC__ along

#if defined(__linux__) && defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#include <cstdlib>
#include <new>

#include <malloc.h>
#include <sys/mman.h>

namespace {

constexpr std::size_t kPage = std::size_t{1} << 21;

void* allocated(std::size_t size) noexcept {
    if (size < kPage) return std::malloc(size > 0 ? size : 1);
    if (size > SIZE_MAX - kPage) return nullptr;
    const std::size_t whole = (size + kPage - 1) / kPage * kPage;
    void* const block = std::aligned_alloc(kPage, whole);
    if (block != nullptr) (void)madvise(block, whole, MADV_HUGEPAGE);  // a wish: may be refused
    return block;
}

/// What is given back stays, to be taken again without faults.
[[maybe_unused]] const bool keeps = [] {
    constexpr int kMost = 32 << 20;  // that glibc accepts
    return mallopt(M_MMAP_THRESHOLD, kMost) != 0 && mallopt(M_TRIM_THRESHOLD, 8 * kMost) != 0;
}();

}  // namespace

void* operator new(std::size_t size) {
    for (;;) {
        if (void* const block = allocated(size)) return block;
        const std::new_handler handler = std::get_new_handler();
        if (handler == nullptr) throw std::bad_alloc();
        handler();
    }
}

void operator delete(void* block) noexcept {
    std::free(block);
}

void operator delete(void* block, std::size_t) noexcept {
    std::free(block);
}
#endif
