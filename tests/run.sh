#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs what is missing, builds with warnings as errors, and runs every test: release, then the library
# under AddressSanitizer and UBSan with a minute of libFuzzer, and its use by several threads under
# ThreadSanitizer.
#   tests/run.sh [PRESET...]     only these of: release asan tsan
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
presets=("$@")
[ ${#presets[@]} -gt 0 ] || presets=(release asan tsan)

libvbm/cmake/apt_install.sh samples/packages.txt tests/packages.txt

mkdir -p build
passed=0 failed=0 skipped=0
for preset in "${presets[@]}"; do
  echo "== $preset"
  SECONDS=0
  options=(-DVBM_TESTS=ON -DVBM_WERROR=ON)
  # Nothing is left out quietly.
  [ "$preset" != release ] || options+=(-DVBM_MESHLAB=REQUIRED)
  cmake --preset "$preset" "${options[@]}" >"build/$preset.log" 2>&1 || { cat "build/$preset.log"; exit 1; }
  cmake --build --preset "$preset"
  echo "built in $SECONDS s"
  result="build/$preset/ctest.xml"
  rm -f "$result"
  status=0
  ctest --preset "$preset" --output-junit "$PWD/$result" || status=$?
  # The counts of the whole run, in the head of CTest's own report.
  count() { sed -n "s/^[[:space:]]*$1=\"\([0-9]*\)\".*/\1/p;T;q" "$result"; }
  tests=$(count tests) bad=$(count failures) left_out=$(($(count skipped) + $(count disabled)))
  # CTest can fail without a failed test, and must not go by unnoticed.
  [ "$status" = 0 ] || [ "$bad" != 0 ] || bad=1
  passed=$((passed + tests - bad - left_out)) failed=$((failed + bad)) skipped=$((skipped + left_out))
done

echo "$passed passed, $failed failed, $skipped skipped"
[ "$failed" = 0 ]
