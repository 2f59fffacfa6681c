// Option tables as command-line options.
#pragma once
#include <string>
#include <string_view>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "tukor/app/option_text.h"

namespace tukor {

/// Adds an option for every row of the struct's table; values land in `options`, which must outlive
/// the parsing. A flag given twice takes the later value; lists grow.
template <class Options>
void addOptions(CLI::App& command, std::string_view heading, Options& options) {
    describe(
        options, [&](std::string_view name, auto& value, const auto& extra, std::string_view help) {
            const std::string flag = "--" + std::string(name);
            const auto read = [&value, extra, flag](const std::vector<std::string>& texts) {
                try {
                    for (const std::string& text : texts) assignFromText(value, extra, text);
                } catch (const Error& error) {
                    throw CLI::ValidationError(flag, error.what());
                }
            };
            CLI::Option* option = command.add_option_function<std::vector<std::string>>(
                flag, read, std::string(help));
            option->allow_extra_args(false)->type_name(usageOf(extra))->group(std::string(heading));
            option->default_str(fmt::format("{}", fmt::join(textsFromOption(value, extra), ", ")));
        });
}

/// MODEL..., and the options of every group.
void addSessionOptions(CLI::App& command, SessionOptions& options);

}  // namespace tukor
