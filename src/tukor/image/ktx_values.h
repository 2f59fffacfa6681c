// The key and value list that both versions of KTX carry.
#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include "tukor/image/byte_writer.h"
#include "tukor/image/texture_file.h"

namespace tukor {

/// The text of a key; none when it is missing or the list is damaged.
[[nodiscard]] std::optional<std::string_view> ktxValue(std::span<const std::byte> list,
                                                       std::string_view key);

/// Appends one entry; the list wants its keys in order.
void appendKtxValue(ByteWriter& out, std::string_view key, std::string_view value);

/// Turns every picture over: the last row comes first.
void flipRows(TextureFile& texture);

}  // namespace tukor
