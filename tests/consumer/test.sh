#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#   test.sh CMAKE BUILD_DIR C_COMPILER VERSION
set -eu
cmake=$1 build=$2 compiler=$3 version=$4
project=$(cd "$(dirname "$0")/project" && pwd)
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT

check() { # NAME PROGRAM...
  name=$1
  shift
  said=$("$@")
  [ "$said" = "8 triangles, volume 1.333" ] || { echo "$name: the program said: $said"; exit 1; }
  echo "$name: $said"
}

# Installed in one place and moved to another, with a space in its name: nothing may remember the first.
"$cmake" --install "$build" --prefix "$dir/first" >"$dir/log" 2>&1 || { cat "$dir/log"; exit 1; }
prefix="$dir/a prefix"
mv "$dir/first" "$prefix"
# Generator and compiler are named; no flags or paths come from the environment.
unset CMAKE_PREFIX_PATH LD_LIBRARY_PATH CPATH LIBRARY_PATH CFLAGS LDFLAGS 2>/dev/null || true

for binary in $(cd "$prefix" && find . -name '*.so' -type f); do
  if (cd "$prefix" && ldd "$binary") | grep 'libvbm.*not found'; then
    echo "installed, but does not find the library: $binary"
    exit 1
  fi
done

"$cmake" -G Ninja -S "$project" -B "$dir/cmake" -DCMAKE_C_COMPILER="$compiler" \
  -DCMAKE_C_FLAGS="-Wall -Wextra -Werror" -DCMAKE_PREFIX_PATH="$prefix" >"$dir/log" 2>&1 &&
  "$cmake" --build "$dir/cmake" >"$dir/log" 2>&1 || { cat "$dir/log"; exit 1; }
check find_package "$dir/cmake/consumer"

library=$(find "$prefix" -name libvbm.so)
PKG_CONFIG_PATH=$(find "$prefix" -type d -name pkgconfig)
export PKG_CONFIG_PATH
[ "$(pkg-config --modversion vbm)" = "$version" ] || { echo "vbm.pc has another version"; exit 1; }
# pkg-config escapes the space as a shell would read it.
eval "$compiler -std=c99 -Wall -Wextra -pedantic -Werror '$project/main.c' -o '$dir/consumer'" \
  "$(pkg-config --cflags --libs vbm)"
check pkg-config env LD_LIBRARY_PATH="$(dirname "$library")" "$dir/consumer"
