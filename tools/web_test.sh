#!/usr/bin/env bash
# Builds the element and runs its tests in headless Chromium.
set -euo pipefail
cd "$(dirname "$0")/.."
echo "== web: build"
tools/web_build.sh
echo "== web: tests"
cd web
exec node --test --test-concurrency=1 test/*.test.mjs
