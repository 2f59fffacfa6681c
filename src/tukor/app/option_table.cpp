#include "tukor/app/option_table.h"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tukor/app/option_text.h"
#include "tukor/app/series.h"
#include "tukor/base/number_text.h"

namespace tukor {
namespace {

/// A JSON value of the option's own type.
nlohmann::ordered_json json(int value) {
    return value;
}
nlohmann::ordered_json json(float value) {
    return numberFromText(textFromValue(value)).value();  // 0.1, not 0.10000000149011612
}
nlohmann::ordered_json json(glm::vec3 value) {
    return {json(value.x), json(value.y), json(value.z)};
}
nlohmann::ordered_json json(const std::vector<std::string>& value) {
    return value;
}

template <class T, class Extra>
nlohmann::ordered_json jsonFromOption(const T& value, const Extra& extra) {
    if constexpr (requires { json(value); }) {
        return json(value);
    } else if constexpr (requires { value.has_value(); }) {
        return value ? jsonFromOption(*value, extra) : nlohmann::ordered_json(nullptr);
    } else {
        const auto texts = textsFromOption(value, extra);
        return texts.empty() ? nlohmann::ordered_json(nullptr)
                             : nlohmann::ordered_json(texts.front());
    }
}

template <class Group>
void addRows(std::vector<OptionRow>& rows, std::string_view heading, const Group& group) {
    describe(group, [&](std::string_view name, const auto& value, const auto& extra,
                        std::string_view help) {
        rows.push_back({std::string(heading), std::string(name), usageOf(extra), boundsOf(extra),
                        std::string(help), textsFromOption(value, extra)});
    });
}

}  // namespace

std::vector<OptionRow> optionRows(const SessionOptions& options) {
    std::vector<OptionRow> rows;
    describeGroups(options, [&](std::string_view heading, const auto& group) {
        addRows(rows, heading, group);
    });
    std::size_t i = 0;
    const SessionOptions defaults;
    describeGroups(defaults, [&](std::string_view, const auto& group) {
        describe(group,
                 [&](std::string_view, const auto& value, const auto& extra, std::string_view) {
                     rows[i].isDefault = rows[i].values == textsFromOption(value, extra);
                     ++i;
                 });
    });
    return rows;
}

std::string shellQuoted(std::string_view word) {
    constexpr std::string_view kPlain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=./,:@%";
    if (!word.empty() && word.find_first_not_of(kPlain) == word.npos) return std::string(word);
    std::string quoted = "'";
    for (const char c : word) {
        if (c == '\'') {
            quoted += "'\\''";
        } else {
            quoted += c;
        }
    }
    return quoted + "'";
}

std::string commandLine(std::string_view program, const SessionOptions& options) {
    std::string line(program);
    const auto add = [&](std::string_view word) {
        if (!line.empty()) line += ' ';
        line += word;
    };
    for (const std::string& model : options.subject.models) {
        // a name that begins with a dash would be read as an option
        add(shellQuoted(model.starts_with('-') ? "./" + model : model));
    }
    for (const OptionRow& row : optionRows(options)) {
        if (row.isDefault) continue;
        for (const std::string& value : row.values) {
            // `--eye -1,0,4` is fine, but a text value with a dash needs the equals sign
            if (value.starts_with('-') && row.bounds.empty()) {
                add(fmt::format("--{}={}", row.name, shellQuoted(value)));
            } else {
                add("--" + row.name);
                add(shellQuoted(value));
            }
        }
    }
    return line;
}

std::string jsonFromOptions(const SessionOptions& options) {
    nlohmann::ordered_json all;
    all["model"] = options.subject.models;
    describeGroups(options, [&](std::string_view, const auto& group) {
        describe(group,
                 [&](std::string_view name, const auto& value, const auto& extra,
                     std::string_view) { all[std::string(name)] = jsonFromOption(value, extra); });
    });
    // file names are bytes; JSON is UTF-8
    return all.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

std::string markdownOfOptions() {
    std::string page =
        "# Options of `tukor render` and `tukor view`\n\n"
        "Written by `tukor markdown-options`; do not edit by hand.\n";
    std::vector<OptionRow> rows = optionRows({});
    addRows(rows, "Several pictures (`tukor render` alone)", SeriesOptions{});
    std::string heading;
    for (const OptionRow& row : rows) {
        if (row.heading != heading) {
            heading = row.heading;
            page += fmt::format(
                "\n## {}\n\n| option | default | range | meaning |\n|---|---|---|---|\n", heading);
        }
        std::string usage;  // a bar ends a table cell, even between backquotes
        for (const char c : row.usage) {
            if (c == '|') usage += '\\';
            usage += c;
        }
        std::string value = fmt::format("{}", fmt::join(row.values, ", "));
        page += fmt::format("| `--{} {}` | {} | {} | {} |\n", row.name, usage,
                            value.empty() ? "" : "`" + value + "`", row.bounds, row.help);
    }
    return page;
}

}  // namespace tukor
