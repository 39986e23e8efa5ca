#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds and tests everything on three generations of Debian, and makes the files of a release there:
# bookworm is this machine, trixie and sid are roots of their own below build/suites (or
# $VBM_SUITES_DIR), each some 5 GB. Run it as root. What is released is left in out/release, also that of suites
# that are not named this time.
#   tests/suites/run.sh [--files-only] [SUITE...]     default: bookworm trixie sid
#   --files-only   builds, packs and tries the files, without the test suite
# A suite that cannot be had is skipped, loudly, unless it is bookworm; one that fails ends this with 1.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)
roots=${VBM_SUITES_DIR:-$root/build/suites}
out=$root/out/release
tests=1
[ "${1:-}" != --files-only ] || { tests=0; shift; }
suites=("$@")
[ ${#suites[@]} -gt 0 ] || suites=(bookworm trixie sid)

skip() { echo "!! $1 is SKIPPED: $2"; skipped+=("$1"); }
fail() { echo "!! $1 FAILED: $2"; failed+=("$1"); }

# A root with nothing in it but what apt-get needs; the project's own scripts install the rest.
make_root() {
  local suite=$1 dir=$roots/$1
  [ ! -e "$dir/COMPLETE" ] || return 0
  command -v mmdebstrap >/dev/null || { echo "mmdebstrap is not installed"; return 1; }
  rm -rf "$dir" && mkdir -p "$roots"
  mmdebstrap --variant=minbase --include=ca-certificates \
    --aptopt='APT::Install-Recommends "false"' --aptopt='Acquire::Check-Valid-Until "false"' \
    "$suite" "$dir" >"$roots/$suite.log" 2>&1 || { tail -n 1 "$roots/$suite.log"; return 1; }
  touch "$dir/COMPLETE"
}

# The working tree as git sees it, and the test data beside it.
fill_root() {
  mkdir -p "$1/libvbm" "$1/shared"
  (cd "$root" && git ls-files -co --exclude-standard -z |
    while IFS= read -r -d '' f; do [ ! -e "$f" ] || printf '%s\0' "$f"; done |
    tar --null -T - -cf -) | tar -C "$1/libvbm" -xf -
}

# enter DIR COMMAND...: in a mount namespace of its own, so that nothing stays mounted.
enter() {
  local dir=$1 data=${VBM_SHARED:-$root/../shared}
  shift
  # shellcheck disable=SC2016
  unshare --mount bash -euc '
    dir=$1 data=$2; shift 2
    mount --rbind /dev "$dir/dev"; mount -t proc proc "$dir/proc"; mount -t sysfs sys "$dir/sys"
    if [ -d "$data" ]; then mount --bind "$data" "$dir/shared"; mount -o remount,bind,ro "$dir/shared"; fi
    exec chroot "$dir" env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 \
      sh -euc "cd /libvbm; \"\$@\"" sh "$@"' enter "$dir" "$data" "$@" </dev/null
}

run_in() { # SUITE COMMAND...
  local suite=$1
  shift
  if [ "$suite" = bookworm ]; then (cd "$root" && "$@"); else enter "$roots/$suite" "$@"; fi
}

is_bookworm() { [ "$(. /etc/os-release && echo "${VERSION_CODENAME:-}")" = bookworm ]; }

skipped=() failed=() done=()
[ "$(id -u)" = 0 ] || { echo "This needs root, for chroot." >&2; exit 1; }
mkdir -p "$out" && rm -f "$out"/*.zip
for suite in "${suites[@]}"; do
  echo "==== $suite"
  rm -rf "${out:?}/$suite"
  if [ "$suite" = bookworm ]; then
    is_bookworm || { fail bookworm "this machine is another Debian"; continue; }
  else
    why=$(make_root "$suite") || { skip "$suite" "$why"; continue; }
    fill_root "$roots/$suite"
  fi
  if [ "$tests" = 1 ]; then
    run_in "$suite" tests/run.sh release || { fail "$suite" "its tests"; continue; }
  fi
  run_in "$suite" tests/suites/pack.sh "out/release/$suite" || { fail "$suite" "packing"; continue; }
  run_in "$suite" tests/suites/check_files.sh "out/release/$suite" || { fail "$suite" "its files"; continue; }
  [ "$suite" = bookworm ] || cp -R "$roots/$suite/libvbm/out/release/$suite" "$out/"
  done+=("$suite")
done

# One extension for all: a wheel for every Python, and for Blender before 4.2, which has no wheels, the
# module itself.
if [ ${#done[@]} -gt 0 ]; then
  echo "==== extension"
  zip=$("$root/blender_addon/pack_release.py" "$out" "$out"/*/*.whl) || failed+=(extension)
  for suite in "${done[@]}"; do
    [ -f "${zip:-}" ] || break
    [ "$suite" = bookworm ] || cp "$zip" "$roots/$suite/libvbm/out/release/"
    run_in "$suite" tests/suites/check_extension.sh "out/release/$(basename "$zip")" ||
      fail "$suite" "the extension"
  done
fi

find "$out" -type f -printf '%P  %k KiB\n' | sort
echo "suites: ${done[*]:-none} done; ${skipped[*]:-none} skipped; ${failed[*]:-none} failed"
[ ${#failed[@]} = 0 ]
