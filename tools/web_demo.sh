#!/usr/bin/env bash
# Builds the element and serves its example page and editor on this machine. PORT chooses the port.
set -euo pipefail
cd "$(dirname "$0")/.."
tools/web_build.sh
exec node web/serve.mjs "${PORT:-8080}"
