#!/usr/bin/env bash
# Installs the Debian packages of the named sections of tools/packages.txt; does nothing when all are there. `NAME or COMMAND`: not where
# that command is there already, from wherever it came.
#
# usage: tools/install_packages.sh build [demo] [test] [web] [bench]
set -euo pipefail
list="$(dirname "$0")/packages.txt"

wanted=()
for section in "$@"; do
    grep -qx "\[$section\]" "$list" || { echo "install_packages.sh: no section [$section] in $list" >&2; exit 2; }
    while read -r name word command _; do
        [ "$word" = or ] && command -v "$command" >/dev/null || wanted+=("$name")
    done < <(
        awk -v s="[$section]" '/^\[/ { on = ($1 == s); next } on && NF && $1 !~ /^#/' "$list")
done

missing=()
for name in "${wanted[@]}"; do
    [ "$(dpkg-query -W -f='${db:Status-Status}' "$name" 2>/dev/null)" = installed ] || missing+=("$name")
done
[ ${#missing[@]} -gt 0 ] || exit 0

as_root=()
if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || { echo "needed packages: ${missing[*]}; install them as root" >&2; exit 1; }
    as_root=(sudo)
fi
echo "Installing ${#missing[@]} Debian packages: ${missing[*]}"
export DEBIAN_FRONTEND=noninteractive
log=$(mktemp)
trap 'rm -f "$log"' EXIT
"${as_root[@]}" apt-get -q update >"$log" 2>&1 || { tail -20 "$log" >&2; exit 1; }
"${as_root[@]}" apt-get -q install -y --no-install-recommends "${missing[@]}" >"$log" 2>&1 || { tail -20 "$log" >&2; exit 1; }
