// What both versions of KTX share: their shape fields, and a list of keys and values.
#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include "tukor/image/byte_reader.h"
#include "tukor/image/byte_writer.h"
#include "tukor/image/texture_file.h"
#include "tukor/image/texture_shape.h"

namespace tukor {

/// True when the bytes start with this identifier.
[[nodiscard]] bool startsWith(std::span<const std::byte> bytes,
                              std::string_view identifier) noexcept;

/// The six numbers from the width to the number of levels, which stand in both headers.
[[nodiscard]] TextureShape readKtxShape(ByteReader& reader);

/// Turns a single picture over where its KTXorientation starts a row count from the bottom, spelt
/// `upwards`.
void applyKtxOrientation(TextureFile& texture, std::span<const std::byte> values,
                         std::string_view upwards);

/// The text of a key; none when it is missing or the list is damaged.
[[nodiscard]] std::optional<std::string_view> ktxValue(std::span<const std::byte> list,
                                                       std::string_view key);

/// Appends one entry; the list wants its keys in order.
void appendKtxValue(ByteWriter& out, std::string_view key, std::string_view value);

}  // namespace tukor
