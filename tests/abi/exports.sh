#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The library exports exactly the functions that the headers declare.
#   exports.sh LIBRARY HEADER...
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT

# The version node itself (VBM_1) is an absolute symbol, type A.
library=$1
shift
nm -D --defined-only "$library" | awk '$2 != "A" { sub(/@.*/, "", $3); print $3 }' | LC_ALL=C sort >"$dir/exported"
cat "$@" | tr '\n' ' ' | sed 's/VBM_API/\nVBM_API/g' | sed -n 's/^VBM_API [^(]*\b\(vbm_[a-z0-9_]*\)(.*/\1/p' |
  LC_ALL=C sort >"$dir/declared"

[ "$(wc -l <"$dir/declared")" -ge 30 ] || { echo "no functions found in $*"; exit 1; }
if ! diff "$dir/declared" "$dir/exported" >"$dir/difference"; then
  echo "Declared in the header but not exported (<), or exported but not declared (>):"
  grep '^[<>]' "$dir/difference"
  exit 1
fi
echo "$(wc -l <"$dir/exported") functions exported, all declared"
