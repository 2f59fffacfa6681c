// The one exception type, and the assertion for callers' mistakes.
#pragma once
#include <stdexcept>
#include <string>

namespace tukor {

/// The world is wrong: a file, its contents, a driver. Never used for flow.
///
/// The message names the thing, what was found, what was expected and the remedy if one exists;
/// lower case, no full stop: `studio.hdr: 2047 x 1024 pixels; an equirectangular panorama must be
/// exactly twice as wide as high`.
class Error : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

namespace detail {
[[noreturn]] void assertionFailed(const char* condition, const char* file, int line);
}

}  // namespace tukor

/// The caller is wrong. Active in dev and sanitizer builds; nothing in release.
#ifdef TUKOR_ASSERTIONS
#define TUKOR_ASSERT(condition) \
    ((condition) ? void(0) : ::tukor::detail::assertionFailed(#condition, __FILE__, __LINE__))
#else
#define TUKOR_ASSERT(condition) void(sizeof(condition))
#endif
