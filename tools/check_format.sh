#!/usr/bin/env bash
# Fails when a C++ file is not as clang-format would write it; `--fix` rewrites those.
#
# usage: tools/check_format.sh [--fix]
set -euo pipefail
cd "$(dirname "$0")/.."
action=(--dry-run -Werror)
[ "${1:-}" != --fix ] || action=(-i)
find src apps examples tests bench fuzz -name '*.cpp' -o -name '*.h' | sort | xargs clang-format "${action[@]}"
