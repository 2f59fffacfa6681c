// OpenEXR's core library over a file in memory.
#pragma once
#include <cstddef>
#include <memory>
#include <span>
#include <string_view>

#include <OpenEXR/openexr.h>

namespace tukor {

struct FinishExr {
    void operator()(exr_context_t context) const noexcept { exr_finish(&context); }
};
using ExrContext = std::unique_ptr<_priv_exr_context_t, FinishExr>;

/// Reads its headers; `bytes` itself, not only what it shows, has to outlive the context. Throws
/// Error, which names the file.
[[nodiscard]] ExrContext openExr(const std::span<const std::byte>& bytes, std::string_view name);

/// Throws Error with the library's last complaint in this thread unless the result is a success.
void requireExr(exr_result_t result, std::string_view name);

}  // namespace tukor
