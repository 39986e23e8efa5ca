#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Validates, installs and runs the release's zip in this machine's Blender, with settings of its own.
#   tests/suites/check_extension.sh ZIP
set -euo pipefail
zip=$(realpath "$1")
cd "$(dirname "${BASH_SOURCE[0]}")"
home=$(mktemp -d)
trap 'rm -rf "$home"' EXIT
export BLENDER_USER_RESOURCES=$home BLENDER_USER_CONFIG=$home/config BLENDER_USER_SCRIPTS=$home/scripts
export PYTHONPATH="" HOME="$home"
mkdir -p "$home/config" "$home/scripts" "$home/extensions"
version=$(blender --background --factory-startup -noaudio --version | sed -n 's/^Blender \([0-9.]*\).*/\1/p;T;q')
run() { "$@" >"$home/log" 2>&1 </dev/null || { tail -n 30 "$home/log" >&2; exit 1; }; }
if [ "$(printf '%s\n' 4.2 "$version" | sort -V | head -n 1)" = 4.2 ]; then
  run blender --background -noaudio --command extension validate "$zip"
  run blender --background -noaudio --command extension install-file -r user_default --enable "$zip"
fi
run blender --background -noaudio --python-exit-code 3 --python check_extension.py -- "$zip"
grep '^extension: ' "$home/log"
