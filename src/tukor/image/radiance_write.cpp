#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "tukor/base/parallel.h"
#include "tukor/image/radiance_file.h"

namespace tukor {

namespace {

/// The nearest RGBE of a value.
std::array<std::byte, 4> rgbeOf(glm::vec3 value) {
    for (int c = 0; c < 3; ++c)
        if (!(value[c] > 0.0f)) value[c] = 0.0f;   // NaN too
    value = glm::min(value, glm::vec3(1.69e38f));  // 255/256 * 2^127, the largest RGBE
    const float most = std::max({value.x, value.y, value.z});
    if (most < 1e-38f) return {};
    int exponent = 0;
    (void)std::frexp(most, &exponent);
    if (std::lround(std::ldexp(most, 8 - exponent)) == 256) ++exponent;
    if (exponent < -127) return {};
    const auto mantissa = [&](float v) {
        return static_cast<std::byte>(std::min(std::lround(std::ldexp(v, 8 - exponent)), 255l));
    };
    return {mantissa(value.x), mantissa(value.y), mantissa(value.z),
            static_cast<std::byte>(exponent + 128)};
}

/// Runs of at least four equal bytes as a run, all else literally.
void appendRuns(std::vector<std::byte>& out, std::span<const std::byte> values) {
    const auto runAt = [&](std::size_t at) {
        std::size_t end = at + 1;
        while (end < values.size() && end - at < 127 && values[end] == values[at]) ++end;
        return end - at;
    };
    for (std::size_t at = 0; at < values.size();) {
        std::size_t literal = 0;
        std::size_t run = runAt(at);
        while (run < 4 && literal + run <= 128) {
            literal += run;
            if (at + literal == values.size()) break;
            run = runAt(at + literal);
        }
        if (literal > 0) {
            out.push_back(static_cast<std::byte>(literal));
            out.insert(out.end(), values.begin() + static_cast<std::ptrdiff_t>(at),
                       values.begin() + static_cast<std::ptrdiff_t>(at + literal));
            at += literal;
        } else {
            out.push_back(static_cast<std::byte>(128 + run));
            out.push_back(values[at]);
            at += run;
        }
    }
}

}  // namespace

std::vector<std::byte> encodeRadiance(
    const Image& image, std::span<const std::pair<std::string, std::string>> metadata) {
    std::string header = "#?RADIANCE\n";
    for (const auto& [key, value] : metadata) {
        std::string line = fmt::format("# {}: {}", key, value);
        std::replace(line.begin(), line.end(), '\n', ' ');
        header += line + '\n';
    }
    header += fmt::format("FORMAT=32-bit_rle_rgbe\n\n-Y {} +X {}\n", image.height(), image.width());
    const auto text = std::as_bytes(std::span(header));
    std::vector<std::byte> out(text.begin(), text.end());

    const auto width = static_cast<std::size_t>(image.width());
    const bool coded = width >= 8 && width <= 32767;
    std::vector<std::vector<std::byte>> rows(static_cast<std::size_t>(image.height()));
    parallelFor(0, image.height(), 16, [&](int begin, int end) {
        std::array<std::vector<std::byte>, 4> planes;
        for (auto& plane : planes) plane.resize(width);
        for (int row = begin; row < end; ++row) {
            std::vector<std::byte>& line = rows[static_cast<std::size_t>(row)];
            if (coded)
                for (std::size_t byte : {std::size_t{2}, std::size_t{2}, width >> 8, width & 255})
                    line.push_back(static_cast<std::byte>(byte));
            for (std::size_t column = 0; column < width; ++column) {
                const auto rgbe = rgbeOf(image.at(static_cast<int>(column), row));
                if (!coded) line.insert(line.end(), rgbe.begin(), rgbe.end());
                for (std::size_t c = 0; c < 4; ++c) planes[c][column] = rgbe[c];
            }
            if (coded)
                for (const auto& plane : planes) appendRuns(line, plane);
        }
    });
    std::size_t size = out.size();
    for (const auto& line : rows) size += line.size();
    out.reserve(size);
    for (const auto& line : rows) out.insert(out.end(), line.begin(), line.end());
    return out;
}

}  // namespace tukor
