#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs what is missing, builds everything, and shows the main job in Blender, without a window: the
# points of a model become balls, and the balls a closed surface. What it made lies in out/demo.
#   samples/run.sh [MODEL]     a mesh file that Blender opens; default: the bunny of Debian's glmark2-data
set -euo pipefail
model=$(realpath -m -- "${1:-/usr/share/glmark2/models/bunny.obj}")
cd "$(dirname "${BASH_SOURCE[0]}")/.."

libvbm/cmake/apt_install.sh samples/packages.txt
mkdir -p build out/demo
log=build/demo.log
run() { "$@" >"$log" 2>&1 </dev/null || { tail -n 40 "$log" >&2; exit 1; }; }

echo "Building (a few minutes the first time)"
run cmake --preset release
grep '^!!' "$log" || true # what had to be left out, and why
run cmake --build --preset release
. build/release/env.sh

# Blender says a good deal of its own; the demo's lines begin with a mark.
run blender --background --factory-startup -noaudio --python-exit-code 1 --python samples/demo/demo.py -- \
  "$model" out/demo
sed -n 's/^demo: //p' "$log"
