// How the program speaks to people: help texts, usage errors, warnings.
#pragma once
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

namespace tukor {

/// Exit statuses, as in other tools.
inline constexpr int kExitFailure = 1;
inline constexpr int kExitUsage = 2;
inline constexpr int kExitInterrupted = 130;  // 128 + SIGINT, as a shell reports it

/// The layout of every --help: two columns, wrapped.
[[nodiscard]] std::shared_ptr<CLI::Formatter> helpFormatter();

/// Prints help, the version or the usage error that ended parsing; returns the exit status.
[[nodiscard]] int reportParseEnd(const CLI::App& program, const CLI::ParseError& end);

/// Arguments as the parser takes them: a value like -.5,0,1 after an option is joined to it by '='.
[[nodiscard]] std::vector<std::string> joinedArguments(int argc, const char* const* argv);

/// `tukor: warning: ...` on stderr, each message once per run.
void warn(std::string_view message);

}  // namespace tukor
