#include "tukor/image/exr_context.h"

#include <algorithm>
#include <cstring>
#include <string>

#include <fmt/format.h>

#include "tukor/base/error.h"

namespace tukor {

namespace {

/// The library prefers a callback to a return value.
thread_local std::string complaint;

void keepComplaint(exr_const_context_t, exr_result_t, const char* message) {
    complaint = message ? message : "";
}

std::int64_t readBytes(exr_const_context_t, void* user, void* buffer, std::uint64_t size,
                       std::uint64_t offset, exr_stream_error_func_ptr_t) {
    const auto& bytes = *static_cast<const std::span<const std::byte>*>(user);
    if (offset >= bytes.size()) return 0;
    const std::uint64_t count = std::min<std::uint64_t>(size, bytes.size() - offset);
    std::memcpy(buffer, bytes.data() + offset, count);
    return static_cast<std::int64_t>(count);
}

std::int64_t sizeOfBytes(exr_const_context_t, void* user) {
    return static_cast<std::int64_t>(static_cast<const std::span<const std::byte>*>(user)->size());
}

}  // namespace

ExrContext openExr(const std::span<const std::byte>& bytes, std::string_view name) {
    exr_context_initializer_t setup = EXR_DEFAULT_CONTEXT_INITIALIZER;
    setup.error_handler_fn = keepComplaint;
    setup.user_data = const_cast<std::span<const std::byte>*>(&bytes);
    setup.read_fn = readBytes;
    setup.size_fn = sizeOfBytes;
    complaint.clear();
    exr_context_t context = nullptr;
    const exr_result_t result = exr_start_read(&context, std::string(name).c_str(), &setup);
    ExrContext owner(context);
    requireExr(result, name);
    return owner;
}

void requireExr(exr_result_t result, std::string_view name) {
    if (result == EXR_ERR_SUCCESS) return;
    throw Error(
        fmt::format("{}: damaged OpenEXR file: {}", name,
                    complaint.empty() ? exr_get_default_error_message(result) : complaint.c_str()));
}

}  // namespace tukor
