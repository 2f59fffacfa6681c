#include "tukor/base/spelling.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <vector>

namespace tukor {

namespace {

constexpr std::size_t kLongestWord = 64;  // beyond, nobody mistyped a name; keeps the table small

char lower(char c) {
    return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
}

}  // namespace

int editDistance(std::string_view a, std::string_view b) {
    const std::size_t columns = b.size() + 1;
    std::vector<int> distance((a.size() + 1) * columns);
    const auto at = [&](std::size_t i, std::size_t j) -> int& { return distance[i * columns + j]; };
    for (std::size_t i = 0; i <= a.size(); ++i) at(i, 0) = static_cast<int>(i);
    for (std::size_t j = 0; j <= b.size(); ++j) at(0, j) = static_cast<int>(j);
    for (std::size_t i = 1; i <= a.size(); ++i) {
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const int different = lower(a[i - 1]) == lower(b[j - 1]) ? 0 : 1;
            at(i, j) = std::min({at(i - 1, j) + 1, at(i, j - 1) + 1, at(i - 1, j - 1) + different});
            if (i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) &&
                lower(a[i - 2]) == lower(b[j - 1])) {
                at(i, j) = std::min(at(i, j), at(i - 2, j - 2) + 1);
            }
        }
    }
    return at(a.size(), b.size());
}

std::string_view nearestName(std::string_view word, std::span<const std::string_view> names) {
    std::string_view nearest;
    if (word.empty() || word.size() > kLongestWord) return nearest;
    int least = 0;
    for (const std::string_view name : names) {
        const int distance = editDistance(word, name);
        const int allowed = std::max(1, static_cast<int>(std::max(word.size(), name.size())) / 3);
        if (distance <= allowed && (nearest.empty() || distance < least)) {
            nearest = name;
            least = distance;
        }
    }
    return nearest;
}

}  // namespace tukor
