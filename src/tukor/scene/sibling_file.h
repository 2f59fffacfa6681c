// The files that a model may name: those beside or below itself, and no others.
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tukor {

/// Where the relative URI of a model points to; it need not exist.
///
/// Throws Error for absolute paths, `..`, other schemes than none, and links that lead out of the
/// model's folder.
[[nodiscard]] std::filesystem::path siblingPath(const std::filesystem::path& model,
                                                std::string_view uri);

/// `%20` and its like decoded. Throws Error where they are malformed; `model` opens the message.
[[nodiscard]] std::string percentDecoded(const std::filesystem::path& model, std::string_view uri);

/// A URI cut down to what fits on a line of a message, unprintable characters replaced.
[[nodiscard]] std::string printable(std::string_view text);

}  // namespace tukor
