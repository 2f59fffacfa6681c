// Memory for pixels: large pieces come in large pages, where the system has them.
#pragma once
#include <cstddef>
#include <new>

namespace tukor {

/// `bytes` of memory aligned to at least 16; from 4 MB on it asks for pages of 2 MB. Touching the
/// small pages of a large picture for the first time costs more than filling it.
[[nodiscard]] void* allocateLarge(std::size_t bytes);
void freeLarge(void* memory, std::size_t bytes) noexcept;

/// For standard containers.
template <class T>
struct LargeAllocator {
    using value_type = T;

    LargeAllocator() = default;
    template <class Other>
    LargeAllocator(const LargeAllocator<Other>&) noexcept {}

    [[nodiscard]] T* allocate(std::size_t count) {
        if (count > static_cast<std::size_t>(-1) / sizeof(T)) throw std::bad_array_new_length();
        return static_cast<T*>(allocateLarge(count * sizeof(T)));
    }
    void deallocate(T* memory, std::size_t count) noexcept { freeLarge(memory, count * sizeof(T)); }

    friend bool operator==(LargeAllocator, LargeAllocator) noexcept { return true; }
};

}  // namespace tukor
