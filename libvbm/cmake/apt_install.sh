#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs those Debian packages of the given lists (one name a line, # for comments) that are missing.
#   apt_install.sh LIST...
set -eu

wanted=$(sed 's/#.*//' "$@" | tr -s '[:space:]' ' ')
if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
  echo "This script installs packages with apt-get, which is not here (it needs Debian 12). What it wants:" >&2
  echo " $wanted" >&2
  exit 1
fi

missing=
for package in $wanted; do
  status=$(dpkg-query -W -f='${db:Status-Status} ' "$package" 2>/dev/null || true)
  case " $status" in *" installed "*) ;; *) missing="$missing $package" ;; esac
done
[ -n "$missing" ] || exit 0

if [ "$(id -u)" = 0 ]; then
  as_root=
elif command -v sudo >/dev/null; then
  as_root=sudo
else
  echo "Packages are missing, and installing them takes root or sudo. As root, run:" >&2
  echo "  apt-get update && apt-get install --no-install-recommends$missing" >&2
  exit 1
fi

# The package index is fetched only if it does not know a package, or is too old to find its file.
install() {
  $as_root env DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8 \
    apt-get install -y --no-install-recommends -o DPkg::Lock::Timeout=600 -o Acquire::Retries=3 \
    "$@" $missing </dev/null
}
log=$(mktemp)
trap 'rm -f "$log"' EXIT
echo "Installing$missing"
if ! install --simulate >"$log" 2>&1 || ! install >"$log" 2>&1; then
  if ! $as_root apt-get update -o Acquire::Retries=3 </dev/null >"$log" 2>&1 ||
    ! install >"$log" 2>&1; then
    tail -n 40 "$log" >&2
    echo "apt-get could not install:$missing" >&2
    exit 1
  fi
fi
