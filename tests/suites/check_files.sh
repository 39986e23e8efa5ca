#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Uses the files of a release as those who get them do: a program built against the unpacked library, the
# wheel installed into an environment of its own, the plugin put into a MeshLab's folders.
#   tests/suites/check_files.sh FOLDER
set -euo pipefail
files=$(cd "$1" && pwd)
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
run() { "$@" >"$dir/log" 2>&1 </dev/null || { tail -n 30 "$dir/log" >&2; exit 1; }; }
one() { # PATTERN: the one file that matches
  local found
  found=$(find "$files" -maxdepth 1 -name "$1")
  [ "$(wc -l <<<"$found")" = 1 ] && [ -f "$found" ] || { echo "not one file is $1: $found" >&2; exit 1; }
  echo "$found"
}
# Nothing of this source tree's build may be found.
unset PYTHONPATH LD_LIBRARY_PATH CMAKE_PREFIX_PATH PKG_CONFIG_PATH

archive=$(one 'libvbm-*.tar.xz')
mkdir "$dir/library" && tar -C "$dir/library" -xJf "$archive"
prefix=$(echo "$dir"/library/*)
[ -f "$prefix/LICENSE" ] || { echo "$archive has no licence" >&2; exit 1; }
run cmake -G Ninja -S tests/consumer/project -B "$dir/consumer" -DCMAKE_PREFIX_PATH="$prefix"
run cmake --build "$dir/consumer"
echo "library: $("$dir/consumer/consumer")"

wheel=$(one '*.whl')
run /usr/bin/python3 -m venv --system-site-packages "$dir/env"
run "$dir/env/bin/pip" install --no-index --no-deps "$wheel"
"$dir/env/bin/python" -c '
import sys, numpy, vbm
assert vbm.__file__.startswith(sys.prefix), vbm.__file__
points = numpy.random.default_rng(0).normal(size=(2000, 3))
points /= numpy.linalg.norm(points, axis=1)[:, None]
surface = vbm.build(points).surface()
assert surface.report.genus == 0 and abs(surface.report.volume - 4.18879) < 0.05, surface.report
print("wheel:", sys.version.split()[0], surface)'

# As the archive's INSTALL says, but not into this machine's own folders.
plugin=$(one 'vbm-meshlab-*.tar.xz')
mkdir -p "$dir/plugin" "$dir/usr/lib" && tar -C "$dir/plugin" -xJf "$plugin"
cp -R "$dir"/plugin/*/lib/* "$dir/usr/lib/"
plugins=$(find "$dir/usr/lib" -type d -name plugins)
for other in /usr/lib/"${plugins#"$dir/usr/lib/"}"/../*.so*; do ln -s "$(realpath "$other")" "$plugins/../$(basename "$other")" 2>/dev/null || true; done
for module in "$plugins"/*.so; do
  /usr/bin/python3 - "$module" <<'PYTHON'
import ctypes, os, sys
library = ctypes.CDLL(sys.argv[1], os.RTLD_NOW)  # every symbol is found
library.qt_plugin_instance
PYTHON
  echo "plugin: $(basename "$module") loads"
done
