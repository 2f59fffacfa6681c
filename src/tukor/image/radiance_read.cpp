#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>

#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/base/number_text.h"
#include "tukor/base/parallel.h"
#include "tukor/image/image_size.h"
#include "tukor/image/radiance_file.h"

namespace tukor {

namespace {

/// What the resolution line says: scanlines run along one axis and follow each other along the
/// other.
struct Resolution {
    int scanlines = 0;
    int length = 0;         // pixels of a scanline
    bool columns = false;   // scanlines are columns
    bool slowDown = false;  // the first axis decreases: -Y, top row first, or -X
    bool fastDown = false;  // the second one does
};

struct Header {
    bool xyz = false;
    glm::dvec3 exposure{1.0};
    Resolution resolution;
    std::size_t end = 0;  // where the pixels start
};

constexpr std::size_t kLongestLine = 1 << 16;

/// The text up to the next line feed; `position` moves behind it.
std::optional<std::string_view> nextLine(std::span<const std::byte> bytes, std::size_t& position) {
    const auto rest = bytes.subspan(position, std::min(bytes.size() - position, kLongestLine));
    const auto feed = std::find(rest.begin(), rest.end(), std::byte{'\n'});
    if (feed == rest.end()) return std::nullopt;
    const auto length = static_cast<std::size_t>(feed - rest.begin());
    position += length + 1;
    std::string_view line(reinterpret_cast<const char*>(rest.data()), length);
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
}

/// Up to `values.size()` numbers of a header line; how many there are.
int parseNumbers(std::string_view text, std::span<double> values) {
    int count = 0;
    for (double& value : values) {
        text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
        const std::size_t end = std::min(text.find_first_of(" \t"), text.size());
        const std::optional<double> number = numberFromText(text.substr(0, end));
        if (!number) break;
        value = *number;
        text.remove_prefix(end);
        ++count;
    }
    return count;
}

/// `-Y 512 +X 1024` and its seven siblings.
std::optional<Resolution> parseResolution(std::string_view line) {
    struct Axis {
        char name;
        bool down;
        int size;
    };
    std::array<Axis, 2> axes{};
    for (Axis& axis : axes) {
        if (line.size() < 4 || (line[0] != '-' && line[0] != '+') ||
            (line[1] != 'X' && line[1] != 'Y') || line[2] != ' ')
            return std::nullopt;
        axis.name = line[1];
        axis.down = line[0] == '-';
        line.remove_prefix(3);
        const auto [end, error] =
            std::from_chars(line.data(), line.data() + line.size(), axis.size);
        if (error != std::errc()) return std::nullopt;
        line.remove_prefix(static_cast<std::size_t>(end - line.data()));
        while (line.starts_with(' ')) line.remove_prefix(1);
    }
    if (axes[0].name == axes[1].name || !line.empty()) return std::nullopt;
    return Resolution{axes[0].size, axes[1].size, axes[0].name == 'X', axes[0].down, axes[1].down};
}

Header readHeader(std::span<const std::byte> bytes, std::string_view name) {
    Header header;
    std::size_t position = 0;
    for (bool first = true;; first = false) {
        const auto line = nextLine(bytes, position);
        if (!line) throw Error(fmt::format("{}: the Radiance header does not end", name));
        if (first) continue;
        if (line->empty()) break;
        std::array<double, 3> numbers{};
        if (line->starts_with("FORMAT=")) {
            const std::string_view format = line->substr(7, line->find_last_not_of(" \t") - 6);
            header.xyz = format == "32-bit_rle_xyze";
            if (!header.xyz && format != "32-bit_rle_rgbe")
                throw Error(fmt::format(
                    "{}: pixel format `{}`; expected 32-bit_rle_rgbe or 32-bit_rle_xyze", name,
                    format));
        } else if (line->starts_with("EXPOSURE=")) {
            if (parseNumbers(line->substr(9), std::span(numbers).first(1)) == 1)
                header.exposure *= numbers[0];
        } else if (line->starts_with("COLORCORR=")) {
            if (parseNumbers(line->substr(10), numbers) == 3)
                header.exposure *= glm::dvec3(numbers[0], numbers[1], numbers[2]);
        }
    }
    for (int c = 0; c < 3; ++c)
        if (!(header.exposure[c] > 1e-30 && header.exposure[c] < 1e30))
            throw Error(fmt::format("{}: exposure {:g}; expected a positive number", name,
                                    header.exposure[c]));
    const auto line = nextLine(bytes, position);
    const auto resolution = line ? parseResolution(*line) : std::nullopt;
    if (!resolution)
        throw Error(
            fmt::format("{}: no resolution line like `-Y 512 +X 1024` after the header", name));
    const Resolution& r = *resolution;
    if (r.scanlines < 1 || r.length < 1)
        throw Error(fmt::format("{}: {} x {} pixels; expected at least 1 x 1", name,
                                r.columns ? r.scanlines : r.length,
                                r.columns ? r.length : r.scanlines));
    checkImageSize(name, static_cast<std::uint64_t>(r.columns ? r.scanlines : r.length),
                   static_cast<std::uint64_t>(r.columns ? r.length : r.scanlines));
    header.resolution = r;
    header.end = position;
    return header;
}

/// The run-length code since 1991: each of the four bytes of the pixels on its own.
bool isPlanar(std::span<const std::byte> bytes, std::size_t at, int length) {
    if (length < 8 || length > 32767 || bytes.size() - at < 4) return false;
    const auto byte = [&](std::size_t i) { return static_cast<unsigned>(bytes[at + i]); };
    return byte(0) == 2 && byte(1) == 2 && byte(2) < 128 &&
           (byte(2) << 8 | byte(3)) == static_cast<unsigned>(length);
}

/// Walks one scanline from `at` and stores its pixels in `rgbe`, unless that is null. Returns the
/// end of the scanline; none when it is damaged or cut off.
std::optional<std::size_t> decodeScanline(std::span<const std::byte> bytes, std::size_t at,
                                          int length, std::byte* rgbe) {
    const auto pixels = static_cast<std::size_t>(length);
    if (isPlanar(bytes, at, length)) {
        at += 4;
        for (std::size_t channel = 0; channel < 4; ++channel) {
            for (std::size_t done = 0; done < pixels;) {
                if (at >= bytes.size()) return std::nullopt;
                auto count = static_cast<std::size_t>(bytes[at++]);
                const bool run = count > 128;
                if (run) count -= 128;
                const std::size_t stored = run ? 1 : count;
                if (count == 0 || count > pixels - done || stored > bytes.size() - at)
                    return std::nullopt;
                if (rgbe)
                    for (std::size_t i = 0; i < count; ++i)
                        rgbe[4 * (done + i) + channel] = bytes[at + (run ? 0 : i)];
                at += stored;
                done += count;
            }
        }
        return at;
    }
    // Flat pixels, and the older code: (1, 1, 1, n) repeats the pixel before it n times; directly
    // after another such, 256 n times, and so on.
    std::size_t factor = 1;
    for (std::size_t done = 0; done < pixels;) {
        if (bytes.size() - at < 4) return std::nullopt;
        const std::byte* pixel = bytes.data() + at;
        at += 4;
        if (pixel[0] == std::byte{1} && pixel[1] == std::byte{1} && pixel[2] == std::byte{1}) {
            const std::size_t count = static_cast<std::size_t>(pixel[3]) * factor;
            if (done == 0 || count > pixels - done || factor > 1u << 24) return std::nullopt;
            if (rgbe)
                for (std::size_t i = 0; i < 4 * count; ++i)
                    rgbe[4 * done + i] = rgbe[4 * done + i - 4];
            done += count;
            factor *= 256;
        } else {
            if (rgbe) std::copy_n(pixel, 4, rgbe + 4 * done);
            ++done;
            factor = 1;
        }
    }
    return at;
}

/// Where each scanline starts. Walks all of them, so that a damaged file costs no pixels.
std::vector<std::size_t> findScanlines(std::span<const std::byte> bytes, const Header& header,
                                       std::string_view name) {
    std::vector<std::size_t> starts;
    std::size_t at = header.end;
    for (int i = 0; i < header.resolution.scanlines; ++i) {
        starts.push_back(at);
        const auto next = decodeScanline(bytes, at, header.resolution.length, nullptr);
        if (!next)
            throw Error(fmt::format("{}: damaged or cut off in scanline {} of {}", name, i + 1,
                                    header.resolution.scanlines));
        at = *next;
    }
    return starts;
}

// CIE XYZ to linear Rec. 709, white D65. [IEC 61966-2-1]
const glm::mat3 kRec709FromXyz{3.2404542f,  -0.9692660f, 0.0556434f,   //
                               -1.5371385f, 1.8760108f,  -0.2040259f,  //
                               -0.4985314f, 0.0415560f,  1.0572252f};

}  // namespace

bool isRadiance(std::span<const std::byte> bytes) noexcept {
    return bytes.size() >= 2 && bytes[0] == std::byte{'#'} && bytes[1] == std::byte{'?'};
}

Image decodeRadiance(std::span<const std::byte> bytes, std::string_view name) {
    if (!isRadiance(bytes)) throw Error(fmt::format("{}: not a Radiance picture", name));
    const Header header = readHeader(bytes, name);
    const Resolution& r = header.resolution;
    const std::vector<std::size_t> starts = findScanlines(bytes, header, name);

    std::array<float, 256> scales{};  // 2^(e - 128) / 256; 0 is black
    for (int e = 1; e < 256; ++e) scales[static_cast<std::size_t>(e)] = std::ldexp(1.0f, e - 136);
    const glm::vec3 gain(1.0 / header.exposure);
    const bool plain = gain == glm::vec3(1.0f);

    Image image(r.columns ? r.scanlines : r.length, r.columns ? r.length : r.scanlines);
    parallelFor(0, r.scanlines, 16, [&](int begin, int end) {
        std::vector<std::byte> rgbe(static_cast<std::size_t>(r.length) * 4);
        for (int i = begin; i < end; ++i) {
            // Checked by findScanlines: it cannot fail now.
            (void)decodeScanline(bytes, starts[static_cast<std::size_t>(i)], r.length, rgbe.data());
            for (int j = 0; j < r.length; ++j) {
                const std::byte* p = rgbe.data() + 4 * static_cast<std::size_t>(j);
                const float scale = scales[static_cast<std::size_t>(p[3])];
                glm::vec3 value =
                    scale * glm::vec3(static_cast<float>(p[0]), static_cast<float>(p[1]),
                                      static_cast<float>(p[2]));
                if (!plain) value *= gain;
                if (header.xyz) value = kRec709FromXyz * value;
                if (r.columns)
                    image.at(r.slowDown ? r.scanlines - 1 - i : i,
                             r.fastDown ? j : r.length - 1 - j) = value;
                else
                    image.at(r.fastDown ? r.length - 1 - j : j,
                             r.slowDown ? i : r.scanlines - 1 - i) = value;
            }
        }
    });
    return image;
}

}  // namespace tukor
