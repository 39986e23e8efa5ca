#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes the files of a release that belong to this machine's generation of Debian, of a finished release
# build, which is brought up to date: the C library, a wheel for its Python, the plugin for its MeshLab.
#   tests/suites/pack.sh OUT
set -euo pipefail
out=$(mkdir -p "$1" && cd "$1" && pwd)
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
libvbm/cmake/apt_install.sh samples/packages.txt tests/suites/packages.txt
build=$PWD/build/release
mkdir -p build
cmake --preset release -DVBM_MESHLAB=REQUIRED >build/pack.log 2>&1 || { cat build/pack.log; exit 1; }
cmake --build --preset release >build/pack.log 2>&1 || { tail -n 40 build/pack.log; exit 1; }
version=$(sed -n 's/^CMAKE_PROJECT_VERSION:STATIC=//p' "$build/CMakeCache.txt")
suite=$(. /etc/os-release && echo "${VERSION_CODENAME:-sid}")
machine=$(uname -m)
stage=$build/stage
rm -rf "$stage" "${out:?}"/*
mkdir -p "$stage"

archive() { # NAME: everything in $stage/NAME, with the licence
  cp LICENSE "$stage/$1/"
  tar -C "$stage" --sort=name --owner=0 --group=0 --numeric-owner -cJf "$out/$1.tar.xz" "$1"
}

library=libvbm-$version-$suite-$machine
cmake --install "$build" --prefix "$stage/$library" --component library >/dev/null
archive "$library"

meshlab=$(sed -n 's/^VBM_MESHLAB_FOUND_VERSION:INTERNAL=//p' "$build/CMakeCache.txt")
plugin=vbm-meshlab-$meshlab-$suite-$machine
cmake --install "$build" --prefix "$stage/prefix" --component meshlab >/dev/null
cp -R "$stage/prefix/lib" "$stage/$plugin-lib"
mkdir -p "$stage/$plugin" && mv "$stage/$plugin-lib" "$stage/$plugin/lib"
plugins=$(find "$stage/$plugin" -type d -name plugins)
cp -L "$build/lib/libvbm.so.1" "$(dirname "$plugins")/"
cat >"$stage/$plugin/INSTALL" <<EOT
The plugin for MeshLab $meshlab: as root, in this folder,
  cp -R lib/* /usr/lib/
EOT
archive "$plugin"

/usr/bin/python3 libvbm/python/make_wheel.py "$build" "$version" "$out"
ls "$out"
