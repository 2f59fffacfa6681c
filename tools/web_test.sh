#!/usr/bin/env bash
# Builds the element and runs its tests in headless Chromium.
set -euo pipefail
cd "$(dirname "$0")/.."
tools/web_build.sh
cd web
exec node --test --test-concurrency=1 test/*.test.mjs
