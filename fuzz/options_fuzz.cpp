// Every option of a picture from hostile text: `NAME=TEXT` a line; what is accepted must come back
// from its own text.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "tukor/app/option_table.h"
#include "tukor/app/option_text.h"
#include "tukor/base/error.h"
#include "tukor/geometry/shapes.h"
#include "tukor/scene/material_text.h"

namespace {

using namespace tukor;

/// Reads `text` into the option `name`, writes it, reads that again: must be the same text.
void readOption(std::string_view name, std::string_view text) {
    SessionOptions options, again;
    std::vector<std::string> first, second;
    describeGroups(options, [&](std::string_view, auto& group) {
        describe(group,
                 [&](std::string_view known, auto& value, const auto& extra, std::string_view) {
                     if (known != name) return;
                     assignFromText(value, extra, text);
                     first = textsFromOption(value, extra);
                 });
    });
    describeGroups(again, [&](std::string_view, auto& group) {
        describe(group,
                 [&](std::string_view known, auto& value, const auto& extra, std::string_view) {
                     if (known != name) return;
                     for (const std::string& one : first) assignFromText(value, extra, one);
                     second = textsFromOption(value, extra);
                 });
    });
    if (first != second) std::abort();
    if (commandLine("tukor render", options).empty() || jsonFromOptions(options).empty()) {
        std::abort();
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::string_view lines(reinterpret_cast<const char*>(data), size);
    while (!lines.empty()) {
        const std::string_view line = lines.substr(0, lines.find('\n'));
        lines.remove_prefix(std::min(lines.size(), line.size() + 1));
        const auto equals = line.find('=');
        if (equals == line.npos) {
            try {
                const auto known = shapeNames();  // building those takes time and proves nothing
                if (std::find(known.begin(), known.end(), line) == known.end()) {
                    if (makeShape(line)) std::abort();
                }
                (void)materialFromText(line);
            } catch (const Error&) {
            }
            continue;
        }
        try {
            readOption(line.substr(0, equals), line.substr(equals + 1));
        } catch (const Error&) {
        }
    }
    return 0;
}
