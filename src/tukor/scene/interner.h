// Numbers things in the order of their first occurrence: vertices that files repeat.
#pragma once
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

namespace tukor {

/// Two indices as one key.
struct IndexPair {
    unsigned first;
    unsigned second;
    friend bool operator==(const IndexPair&, const IndexPair&) = default;
};

/// A set of keys with numbers 0, 1, 2... in the order of insertion; at most 2^31 of them.
///
/// Key is glm::vec3 (equal where all floats are equal: -0 is 0) or IndexPair.
template <class Key>
class Interner {
public:
    explicit Interner(std::size_t expected = 0) {
        std::size_t size = 16;
        while (size < 2 * expected) size *= 2;
        slots_.assign(size, kFree);
        keys_.reserve(expected);
    }

    /// The number of `key`, a new one where it is new.
    unsigned add(const Key& key) {
        std::size_t slot = hash(key) & (slots_.size() - 1);
        while (slots_[slot] != kFree) {
            if (keys_[slots_[slot]] == key) return slots_[slot];
            slot = (slot + 1) & (slots_.size() - 1);
        }
        const auto number = static_cast<unsigned>(keys_.size());
        slots_[slot] = number;
        keys_.push_back(key);
        if (2 * keys_.size() > slots_.size()) grow();
        return number;
    }

    [[nodiscard]] const std::vector<Key>& keys() const noexcept { return keys_; }
    [[nodiscard]] std::vector<Key> take() && noexcept { return std::move(keys_); }

private:
    static constexpr unsigned kFree = ~0u;

    static std::size_t mixed(std::uint64_t a, std::uint64_t b) noexcept {
        std::uint64_t h = a * 0x9e3779b97f4a7c15ull ^ (b + 0x7f4a7c15ull) * 0xc2b2ae3d27d4eb4full;
        h ^= h >> 32;  // the finaliser of splitmix64, shortened
        h *= 0xbf58476d1ce4e5b9ull;
        return static_cast<std::size_t>(h ^ h >> 29);
    }
    static std::size_t hash(const IndexPair& key) noexcept { return mixed(key.first, key.second); }
    static std::size_t hash(glm::vec3 key) noexcept {
        key += 0.0f;  // -0 becomes 0
        std::uint32_t bits[3];
        std::memcpy(bits, &key, sizeof bits);
        return mixed(std::uint64_t{bits[0]} << 32 | bits[1], bits[2]);
    }

    void grow() {
        slots_.assign(2 * slots_.size(), kFree);
        for (std::size_t i = 0; i < keys_.size(); ++i) {
            std::size_t slot = hash(keys_[i]) & (slots_.size() - 1);
            while (slots_[slot] != kFree) slot = (slot + 1) & (slots_.size() - 1);
            slots_[slot] = static_cast<unsigned>(i);
        }
    }

    std::vector<Key> keys_;
    std::vector<unsigned> slots_;  // open addressing, at most half full
};

}  // namespace tukor
