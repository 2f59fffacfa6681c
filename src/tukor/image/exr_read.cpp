#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfChromaticities.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfRgbaFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfThreading.h>
#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/image/exr_check.h"
#include "tukor/image/exr_file.h"
#include "tukor/image/exr_zip.h"

namespace tukor {

namespace {

using Imath::Box2i;
using Imath::V2i;

class MemoryInput : public Imf::IStream {
public:
    MemoryInput(std::span<const std::byte> bytes, std::string_view name)
        : IStream(std::string(name).c_str()), bytes_(bytes) {}

    bool read(char out[], int count) override {
        const auto size = static_cast<std::uint64_t>(std::max(count, 0));
        if (position_ > bytes_.size() || size > bytes_.size() - position_)
            throw Error("the file ends early");
        std::memcpy(out, bytes_.data() + position_, size);
        position_ += size;
        return position_ < bytes_.size();
    }
    std::uint64_t tellg() override { return position_; }
    void seekg(std::uint64_t position) override { position_ = position; }

private:
    std::span<const std::byte> bytes_;
    std::uint64_t position_ = 0;
};

/// What to read from one part.
struct Source {
    int part = 0;
    std::string prefix;      // of the channels of a layer, with its dot
    bool luminance = false;  // Y instead of R, G, B
    bool chroma = false;     // RY and BY beside it
    bool alpha = false;
};

bool isFlat(const Imf::Header& header) {
    return !header.hasType() || header.type() == Imf::SCANLINEIMAGE ||
           header.type() == Imf::TILEDIMAGE;
}

/// `R` for the channels of the file itself first, then those of a layer, Blender's `Combined`
/// before others.
std::optional<Source> sourceIn(const Imf::Header& header, int part) {
    const Imf::ChannelList& channels = header.channels();
    const auto has = [&](const std::string& name) { return channels.findChannel(name) != nullptr; };
    Source source;
    source.part = part;
    std::optional<std::string> layer;
    for (auto channel = channels.begin(); channel != channels.end(); ++channel) {
        const std::string name = channel.name();
        if (name != "R" && !name.ends_with(".R")) continue;
        const std::string prefix = name.substr(0, name.size() - 1);
        if (!has(prefix + "G") || !has(prefix + "B")) continue;
        if (!layer || prefix.empty() || (!layer->empty() && prefix.ends_with("Combined.")))
            layer = prefix;
    }
    if (layer) {
        source.prefix = *layer;
        source.alpha = has(*layer + "A");
        return source;
    }
    if (!has("Y")) return std::nullopt;
    source.luminance = true;
    source.chroma = has("RY") && has("BY");
    source.alpha = has("A");
    return source;
}

Source findSource(const Imf::MultiPartInputFile& file, std::string_view name) {
    std::string found;
    for (int part = 0; part < file.parts(); ++part) {
        const Imf::Header& header = file.header(part);
        if (!isFlat(header)) {
            found += fmt::format("{}deep data", found.empty() ? "" : ", ");
            continue;
        }
        if (auto source = sourceIn(header, part)) return *source;
        int listed = 0;
        for (auto c = header.channels().begin(); c != header.channels().end() && listed < 16;
             ++c, ++listed)
            found += fmt::format("{}{}", found.empty() ? "" : ", ", c.name());
    }
    throw Error(fmt::format("{}: no colour in it: found {}; expected channels R, G, B or Y", name,
                            found.empty() ? "no channels" : found));
}

/// An image of exactly the data window.
struct Pixels {
    Image image;
    Box2i window;
};

Pixels readChannels(std::span<const std::byte> bytes, Imf::MultiPartInputFile& file,
                    const Source& source, std::string_view name) {
    Imf::InputPart input(file, source.part);
    const Box2i window = input.header().dataWindow();
    const int width = window.max.x - window.min.x + 1;
    const int height = window.max.y - window.min.y + 1;
    Pixels out{Image(width, height), window};
    Imf::FrameBuffer frame;
    std::vector<ExrSlice> slices;
    const auto insert = [&](const std::string& channel, float* first, std::size_t floats) {
        const Imf::Channel& found = input.header().channels()[channel];
        if (found.xSampling != 1 || found.ySampling != 1)
            throw Error(
                fmt::format("{}: channel {} is stored at a lower resolution; only RY and BY "
                            "may be",
                            name, channel));
        slices.push_back({channel, first, floats});
        frame.insert(channel,
                     Imf::Slice::Make(Imf::FLOAT, first, window, floats * sizeof(float),
                                      floats * sizeof(float) * static_cast<std::size_t>(width)));
    };
    float* first = &out.image.pixels()[0].x;
    if (source.luminance) {
        insert("Y", first, 3);
    } else {
        insert(source.prefix + "R", first, 3);
        insert(source.prefix + "G", first + 1, 3);
        insert(source.prefix + "B", first + 2, 3);
    }
    if (source.alpha) {
        out.image.alpha.resize(out.image.pixels().size());
        insert(source.prefix + "A", out.image.alpha.data(), 1);
    }
    if (!readZipScanlines(bytes, source.part, slices)) {
        input.setFrameBuffer(frame);
        input.readPixels(window.min.y, window.max.y);
    }
    if (source.luminance)
        for (glm::vec3& pixel : out.image.pixels()) pixel = glm::vec3(pixel.x);
    return out;
}

/// Luminance at full and chroma at quarter resolution, which the library knows how to join.
Pixels readLuminanceChroma(std::span<const std::byte> bytes, bool alpha, std::string_view name) {
    MemoryInput stream(bytes, name);
    Imf::RgbaInputFile input(stream);
    const Box2i window = input.dataWindow();
    const int width = window.max.x - window.min.x + 1;
    const int height = window.max.y - window.min.y + 1;
    Pixels out{Image(width, height), window};
    if (alpha) out.image.alpha.resize(out.image.pixels().size());
    std::vector<Imf::Rgba> line(static_cast<std::size_t>(width));
    for (int y = window.min.y; y <= window.max.y; ++y) {
        input.setFrameBuffer(line.data() - window.min.x, 1, 0);
        input.readPixels(y);
        const int row = y - window.min.y;
        for (int x = 0; x < width; ++x) {
            const Imf::Rgba& p = line[static_cast<std::size_t>(x)];
            out.image.at(x, row) = glm::vec3(float(p.r), float(p.g), float(p.b));
            if (alpha)
                out.image.alpha[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                                static_cast<std::size_t>(x)] = p.a;
        }
    }
    return out;
}

/// The display window of it; black and transparent where there are no data.
Image displayed(Pixels&& pixels, const Box2i& display, std::string_view name) {
    if (display == pixels.window) return std::move(pixels.image);
    const Box2i common(V2i(std::max(display.min.x, pixels.window.min.x),
                           std::max(display.min.y, pixels.window.min.y)),
                       V2i(std::min(display.max.x, pixels.window.max.x),
                           std::min(display.max.y, pixels.window.max.y)));
    if (common.isEmpty())
        throw Error(fmt::format("{}: all of its pixels lie outside its display window", name));
    Image out(display.max.x - display.min.x + 1, display.max.y - display.min.y + 1);
    const bool covers = common == display;
    const bool alpha = !pixels.image.alpha.empty();
    if (alpha || !covers) out.alpha.assign(out.pixels().size(), 0.0f);
    for (int y = common.min.y; y <= common.max.y; ++y)
        for (int x = common.min.x; x <= common.max.x; ++x) {
            const int column = x - display.min.x;
            const int row = y - display.min.y;
            const int fromColumn = x - pixels.window.min.x;
            const int fromRow = y - pixels.window.min.y;
            out.at(column, row) = pixels.image.at(fromColumn, fromRow);
            if (!out.alpha.empty())
                out.alpha[static_cast<std::size_t>(row) * out.width() + column] =
                    alpha ? pixels.image
                                .alpha[static_cast<std::size_t>(fromRow) * pixels.image.width() +
                                       fromColumn]
                          : 1.0f;
        }
    return out;
}

glm::vec3 whiteOf(const Imf::Chromaticities& primaries) {
    const Imath::V2f w = primaries.white;
    return glm::vec3(w.x, w.y, 1.0f - w.x - w.y) / w.y;
}

/// XYZ under one white as it looks under another. [Bradford: Lam 1985]
glm::mat3 adaptation(glm::vec3 from, glm::vec3 to) {
    const glm::mat3 coneFromXyz = glm::transpose(glm::mat3(
        0.8951f, 0.2664f, -0.1614f, -0.7502f, 1.7135f, 0.0367f, 0.0389f, -0.0685f, 1.0296f));
    const glm::vec3 gain = (coneFromXyz * to) / (coneFromXyz * from);
    const glm::mat3 scale(gain.x, 0, 0, 0, gain.y, 0, 0, 0, gain.z);
    return glm::inverse(coneFromXyz) * scale * coneFromXyz;
}

/// To linear Rec. 709, when the file names other primaries: their white becomes ours.
void convertPrimaries(Image& image, const Imf::Header& header) {
    if (!Imf::hasChromaticities(header)) return;
    const Imf::Chromaticities theirs = Imf::chromaticities(header);
    const Imf::Chromaticities ours;
    const auto near = [](const Imath::V2f& a, const Imath::V2f& b) {
        return std::abs(a.x - b.x) < 2e-3f &&
               std::abs(a.y - b.y) < 2e-3f;  // three digits are usual
    };
    if (near(theirs.red, ours.red) && near(theirs.green, ours.green) &&
        near(theirs.blue, ours.blue) && near(theirs.white, ours.white))
        return;
    const auto columns = [](const Imath::M44f& rows) {
        glm::mat3 m;
        for (int from = 0; from < 3; ++from)
            for (int to = 0; to < 3; ++to) m[from][to] = rows[from][to];
        return m;
    };
    const glm::mat3 rec709FromTheirs = columns(Imf::XYZtoRGB(ours, 1.0f)) *
                                       adaptation(whiteOf(theirs), whiteOf(ours)) *
                                       columns(Imf::RGBtoXYZ(theirs, 1.0f));
    for (int i = 0; i < 9; ++i)  // degenerate primaries mean nothing
        if (!std::isfinite(rec709FromTheirs[i / 3][i % 3])) return;
    for (glm::vec3& pixel : image.pixels()) pixel = rec709FromTheirs * pixel;
}

Image decode(std::span<const std::byte> bytes, std::string_view name) {
    startExrThreads();
    MemoryInput stream(bytes, name);
    Imf::MultiPartInputFile file(stream, Imf::globalThreadCount(), false);
    const Source source = findSource(file, name);
    const Imf::Header& header = file.header(source.part);
    const Box2i display = header.displayWindow();
    Pixels pixels = source.chroma && file.parts() == 1
                        ? readLuminanceChroma(bytes, source.alpha, name)
                        : readChannels(bytes, file, source, name);
    Image image = displayed(std::move(pixels), display, name);
    convertPrimaries(image, header);
    return image;
}

}  // namespace

bool isExr(std::span<const std::byte> bytes) noexcept {
    constexpr unsigned char kMagic[] = {0x76, 0x2f, 0x31, 0x01};
    return bytes.size() >= 4 && std::memcmp(bytes.data(), kMagic, 4) == 0;
}

Image decodeExr(std::span<const std::byte> bytes, std::string_view name) {
    if (!isExr(bytes)) throw Error(fmt::format("{}: not an OpenEXR file", name));
    checkExr(bytes, name);
    try {
        return decode(bytes, name);
    } catch (const Error& error) {
        if (std::string_view(error.what()).starts_with(name)) throw;
        throw Error(fmt::format("{}: damaged OpenEXR file: {}", name, error.what()));
    } catch (const std::exception& error) {
        throw Error(fmt::format("{}: damaged OpenEXR file: {}", name, error.what()));
    }
}

}  // namespace tukor
