// How the program speaks to who called it: exit statuses and warnings.
#pragma once
#include <string_view>

namespace tukor {

/// Exit statuses, as in other tools.
inline constexpr int kExitFailure = 1;
inline constexpr int kExitUsage = 2;
inline constexpr int kExitInterrupted = 130;  // 128 + SIGINT, as a shell reports it

/// `tukor: warning: ...` on stderr, each message once per run.
void warn(std::string_view message);

}  // namespace tukor
