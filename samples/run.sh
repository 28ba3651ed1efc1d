#!/usr/bin/env bash
# Installs what is missing, builds, and runs the main job on the gored skirt. As root or with sudo; Debian 12.
# samples/run.sh [RECIPE [OUTPUT FOLDER]]
set -euo pipefail
cd "$(dirname "$0")/.."
recipe=${1:-samples/gored_skirt/shorten.toml}
out=${2:-out/$(basename "$recipe" .toml)}
.ci/setup build
# Tests that are already configured stay so; a first build leaves them out, for speed.
[ -f build/CMakeCache.txt ] || cmake -S . -B build -G Ninja -DTOILE_TESTS=OFF >/dev/null
cmake --build build --target toile
build/toile run "$recipe" --out "$out" --force
