#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Fetches the headers a MeshLab plugin is compiled against. No Debian package has them, but MeshLab's
# source package does, with vcglib in it, in exactly the version of the installed program.
#
#   fetch_headers.sh DIR    leaves DIR/<version>/{src,vcglib,...} and prints that folder's name
#
# Run again it finds what it left and fetches nothing. It works without root and leaves the machine's
# own package sources and lists alone: it makes a private set of both, where each `deb` source of the
# machine stands as a `deb-src` one. On failure it prints one line saying why to stderr, and exits 1.
set -eu

fail() { echo "$1" >&2; exit 1; }

[ $# -eq 1 ] || fail "usage: fetch_headers.sh DIR"
for tool in apt-get dpkg-query dpkg-source tar; do
  command -v "$tool" >/dev/null || fail "$tool is not installed, so MeshLab's headers cannot be fetched"
done

package=$(dpkg-query -W -f '${source:Package}' meshlab 2>/dev/null) || fail "the package meshlab is not installed"
version=$(dpkg-query -W -f '${source:Version}' meshlab)
[ -n "$version" ] || fail "the package meshlab is not installed"
upstream=$(echo "$version" | sed 's/^[0-9]*://; s/-[^-]*$//')

mkdir -p "$1"
cache=$(cd "$1" && pwd)
done_dir="$cache/$version"
if [ -f "$done_dir/COMPLETE" ]; then
  echo "$done_dir"
  exit 0
fi

work=$(mktemp -d "$cache/fetch.XXXXXX")
trap 'rm -rf "$work"' EXIT
mkdir -p "$work/parts" "$work/lists/partial" "$work/cache/archives/partial" "$work/source"

# The machine's sources, as source-package sources.
n=0
for file in /etc/apt/sources.list /etc/apt/sources.list.d/*.list; do
  [ -f "$file" ] || continue
  n=$((n + 1))
  sed -n 's/^[[:space:]]*deb\([[:space:]]\)/deb-src\1/p' "$file" >"$work/parts/$n.list"
done
for file in /etc/apt/sources.list.d/*.sources; do
  [ -f "$file" ] || continue
  n=$((n + 1))
  sed 's/^Types:.*/Types: deb-src/' "$file" >"$work/parts/$n.sources"
done

apt() {
  command_name=$1
  shift
  apt-get "$command_name" -q -y \
    -o Dir::Etc::SourceList=/dev/null -o Dir::Etc::SourceParts="$work/parts" \
    -o Dir::State::lists="$work/lists" -o Dir::Cache="$work/cache" \
    -o Dir::Cache::pkgcache= -o Dir::Cache::srcpkgcache= \
    -o Acquire::Languages=none -o Acquire::Retries=3 -o Acquire::http::Timeout=60 \
    -o APT::Sandbox::User= -o APT::Update::Post-Invoke-Success= "$@" >>"$work/log" 2>&1
}

# One third-party source without source packages makes `update` fail, but does no harm. Some mirrors
# keep the upstream tarball of a package but not its packaging: the tarball alone is enough.
apt update || true
(cd "$work/source" && apt source --download-only --only-source "$package=$version") || true
dsc=$(find "$work/source" -name '*.dsc' | head -n 1)
tarball=$(find "$work/source" -name "${package}_${upstream}.orig.tar.*" ! -name '*.asc' | head -n 1)
if [ -z "$tarball" ]; then
  tail -n 3 "$work/log" >&2
  fail "the source package $package $version could not be fetched by apt-get"
fi
# Patched, where the packaging is there, as the installed program was.
if [ -z "$dsc" ] || ! dpkg-source --no-check -x "$dsc" "$work/tree" >>"$work/log" 2>&1; then
  rm -rf "$work/tree"
  mkdir "$work/tree"
  tar -xf "$tarball" -C "$work/tree" --strip-components=1
fi

# Keep what compiling a plugin can include, and the version file that 2021.05 and later have.
mkdir "$work/keep"
(cd "$work/tree" && find . \( -path './src/common/*' -o -path './vcglib/*' -o -path './src/vcglib/*' \
    -o -path './ML_VERSION' \) -type f \( -name '*.h' -o -name '*.hpp' -o -name '*.ipp' -o -name '*.inl' \
    -o -name 'ply*.cpp' -o -name 'ML_VERSION' -o -path '*/eigenlib/*' \) -print0 |
  tar -cf - --null -T -) | tar -xf - -C "$work/keep"
find "$work/keep" -name '*.h' | grep -q common/ || fail "the source package $package $version holds no headers"
touch "$work/keep/COMPLETE"
rm -rf "$done_dir"
mv "$work/keep" "$done_dir"
echo "$done_dir"
