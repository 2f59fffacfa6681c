// The subcommands: each registers itself with the parser and leaves what is to be done.
#pragma once
#include <functional>

#include <CLI/CLI.hpp>

namespace tukor {

/// What the parsed command line asks for; returns the exit status. Runs after parsing, so that
/// every usage error is met before any work is done.
using Action = std::function<int()>;

void addRenderCommand(CLI::App& program, Action& action);
void addViewCommand(CLI::App& program, Action& action);
void addMaterialsCommand(CLI::App& program, Action& action);
void addCompareCommand(CLI::App& program, Action& action);
void addEnvironmentCommand(CLI::App& program, Action& action);

}  // namespace tukor
