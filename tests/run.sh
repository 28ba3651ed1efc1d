#!/usr/bin/env bash
# Installs what is missing, builds, runs the tests. As root or with sudo; Debian 12.
set -euo pipefail
cd "$(dirname "$0")/.."
.ci/setup build test
build=${BUILD:-build}
# shellcheck disable=SC2086
cmake -S . -B "$build" -G Ninja -DTOILE_TESTS=ON ${TOILE_CMAKE_OPTIONS:-} >"${TMPDIR:-/tmp}/toile-configure.log" || {
  cat "${TMPDIR:-/tmp}/toile-configure.log" >&2; exit 1; }
cmake --build "$build"
ctest --test-dir "$build" --output-on-failure -j "$(nproc)"
