// ZIP-compressed scanlines of OpenEXR files, in a third of the time that its own library takes.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace tukor {

/// Where a channel goes: that of the data window's first pixel, and from one pixel to the next.
struct ExrSlice {
    std::string channel;
    float* first;
    std::size_t step;
};

/// Fills the slices with a part's data window, row by row; `bytes` have passed checkExr.
///
/// False, whatever the slices hold by then, where the part is anything but sound ZIP-compressed
/// scanlines of half and float channels at full resolution: the library reads it, or knows what is
/// wrong.
[[nodiscard]] bool readZipScanlines(const std::span<const std::byte>& bytes, int part,
                                    std::span<const ExrSlice> slices);

/// As ZIP wants bytes before they are compressed: those at even places before those at odd ones,
/// each as its difference from the one before it.
[[nodiscard]] std::vector<std::uint8_t> predictedForZip(std::span<const std::uint8_t> bytes);

/// The inverse; `out` is as large.
void unpredictedFromZip(std::span<const std::uint8_t> bytes, std::span<std::uint8_t> out);

}  // namespace tukor
