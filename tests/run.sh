#!/usr/bin/env bash
# Builds with warnings as errors and runs the tests: tests/run.sh [gcc] [clang] [sanitize]. Without arguments: gcc and clang.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
source "$root/tests/setup.sh"
need cmake ninja-build g++ clang libglm-dev catch2 libboost-dev libxsimd-dev libgtest-dev

presets=("$@")
(($#)) || presets=(gcc clang)
[[ " ${presets[*]} " != *" sanitize "* ]] || need libclang-rt-dev

cd "$root"
for preset in "${presets[@]}"; do
    cmake --preset "$preset"
    cmake --build --preset "$preset"
done
failed=0
for preset in "${presets[@]}"; do
    ctest --preset "$preset" --parallel "$(nproc)" || failed=1
done
exit $failed
