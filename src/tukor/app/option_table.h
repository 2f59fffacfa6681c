// The option tables as data: for help texts, docs/options.md, JSON and command lines.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "tukor/app/options.h"

namespace tukor {

/// One option as people read about it.
struct OptionRow {
    std::string heading;
    std::string name;    // without dashes
    std::string usage;   // what stands for the value: `DEG`, `quad|box`
    std::string bounds;  // `1 to 175`, or empty
    std::string help;
    std::vector<std::string> values;  // texts that give it its value now; none: not set
    bool isDefault = true;
};

/// All options of a session in the order of the documentation, with their values.
[[nodiscard]] std::vector<OptionRow> optionRows(const SessionOptions& options);

/// `MODEL... --flag value ...` in shell syntax: what gives `options` from the defaults. With
/// `program` before it, a command line.
[[nodiscard]] std::string commandLine(std::string_view program, const SessionOptions& options);

/// One word as a POSIX shell takes it, quoted only where needed.
[[nodiscard]] std::string shellQuoted(std::string_view word);

/// All values, set or default, as a JSON object with a member per option; unset ones are null.
[[nodiscard]] std::string jsonFromOptions(const SessionOptions& options);

/// The text of docs/options.md.
[[nodiscard]] std::string markdownOfOptions();

}  // namespace tukor
