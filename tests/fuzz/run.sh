#!/usr/bin/env bash
# Fuzzes under the sanitizers: tests/fuzz/run.sh [seconds], 60 by default (an hour before a release: 3600), three quarters of them in the
# stated domain, the rest on any bits.
# New inputs stay in build/fuzz; one that breaks an invariant is printed and kept there as well.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
source "$root/scripts/setup.sh"
need cmake ninja-build clang libclang-rt-dev libglm-dev catch2 libboost-dev libxsimd-dev
seconds=${1:-60}

cd "$root"
cmake --preset fuzz
cmake --build --preset fuzz
fuzz() {
    local name=$1 time=$2 out=build/fuzz/inputs_$1
    mkdir -p "$out"
    "build/fuzz/tests/fuzz/$name" -seed=1 -max_total_time="$time" -max_len=512 -artifact_prefix="$out/broken_" -verbosity=0 -print_funcs=0 -entropic=0 "$out" tests/fuzz/corpus
}
fuzz lobe_fuzz $((seconds * 3 / 4))
fuzz lobe_fuzz_any_bits $((seconds - seconds * 3 / 4))
