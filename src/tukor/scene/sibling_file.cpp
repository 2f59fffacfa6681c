#include "tukor/scene/sibling_file.h"

#include <algorithm>
#include <system_error>

#include <fmt/format.h>

#include "tukor/base/error.h"

namespace tukor {

namespace fs = std::filesystem;

namespace {

int hexDigit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

// Whether `path` is `folder` or lies below it, both without links.
[[maybe_unused]] bool isBelow(const fs::path& path, const fs::path& folder) {
    return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first ==
           folder.end();
}

}  // namespace

std::string printable(std::string_view text) {
    constexpr std::size_t kLongest = 80;
    std::string shown(text.substr(0, kLongest));
    for (char& c : shown)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
    return text.size() > kLongest ? shown + "..." : shown;
}

std::string percentDecoded(const fs::path& model, std::string_view uri) {
    std::string decoded;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        if (uri[i] != '%') {
            decoded += uri[i];
            continue;
        }
        const int high = i + 2 < uri.size() ? hexDigit(uri[i + 1]) : -1;
        const int low = high >= 0 ? hexDigit(uri[i + 2]) : -1;
        if (low < 0)
            throw Error(fmt::format("{}: '{}' is not a URI: '%' without two hexadecimal digits",
                                    model.string(), printable(uri)));
        decoded += static_cast<char>(high * 16 + low);
        i += 2;
    }
    return decoded;
}

fs::path siblingPath(const fs::path& model, std::string_view uri) {
    const auto refuse = [&](const char* reason) {
        return Error(
            fmt::format("{}: refers to '{}': {}; a model may only name files below its own "
                        "folder",
                        model.string(), printable(uri), reason));
    };
    const std::string name = percentDecoded(model, uri);
    if (name.empty()) throw refuse("an empty name");
    if (name.find('\0') != std::string::npos) throw refuse("a name with a zero byte");
    if (name.find(':') != std::string::npos) throw refuse("a URI with a scheme or a drive");
    if (name.find('\\') != std::string::npos) throw refuse("a name with a backslash");
    const fs::path relative(name);
    if (relative.is_absolute()) throw refuse("an absolute path");
    if (std::find(relative.begin(), relative.end(), "..") != relative.end())
        throw refuse("a path with '..'");

#ifdef __EMSCRIPTEN__
    return model.parent_path() / relative;  // in memory, where no links lead elsewhere
#else
    const fs::path folder = model.has_parent_path() ? model.parent_path() : fs::path(".");
    std::error_code error;
    const fs::path inside = fs::weakly_canonical(folder, error);
    if (error) throw refuse("its folder cannot be found");
    fs::path target = fs::weakly_canonical(folder / relative, error);
    if (error) throw refuse("a path that cannot be followed");
    if (!isBelow(target, inside)) throw refuse("a link that leads elsewhere");
    return target;
#endif
}

}  // namespace tukor
