#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes the figures of the thesis's chapter 7 again, in Blender, without a window; they lie in
# out/simplification.
#   samples/simplification/run.sh [FIGURE...]     bunny bird ear bone fan graph; default: all
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
libvbm/cmake/apt_install.sh samples/packages.txt
mkdir -p build
log=build/simplification.log
run() { "$@" >"$log" 2>&1 </dev/null || { tail -n 40 "$log" >&2; exit 1; }; }
echo "Building (a few minutes the first time)"
run cmake --preset release
run cmake --build --preset release
. build/release/env.sh
run blender --background --factory-startup -noaudio --python-exit-code 1 \
  --python samples/simplification/figures.py -- out/simplification "$@"
sed -n 's/^figure: //p' "$log"
