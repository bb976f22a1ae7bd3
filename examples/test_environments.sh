#!/usr/bin/env bash
# Builds and runs the tests of the example's reader of environments: once as the example is built, once under -ffast-math, where
# a NaN has to be found all the same.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
source "$root/scripts/setup.sh"
need cmake ninja-build g++ libglm-dev libopenexr-dev libstb-dev libcli11-dev libtbb-dev fonts-dejavu-core
cd "$root"
tests=(test_environments test_environments_fast_math)
cmake --preset release --log-level=NOTICE >/dev/null
cmake --build --preset release --target "${tests[@]}"
for test in "${tests[@]}"; do "build/release/examples/$test"; done
