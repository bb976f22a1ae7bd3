#!/usr/bin/env bash
# Builds and runs the writer of shaders: examples/emit_shader/run.sh --language wgsl --brdf "ggx smith_correlated schlick" (--help, --list).
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
source "$root/scripts/setup.sh"
need g++ libglm-dev libcli11-dev >&2

# one file, so one call of the compiler; kept until a header changes
program=$root/build/emit_shader
newest=$(find "$root/include" "$root/examples/emit_shader" -name '*.[hc]pp' -newer "$program" -print -quit 2>/dev/null || echo none)
if [[ ! -x $program || $newest ]]; then
    mkdir -p "$root/build"
    "${CXX:-c++}" -std=c++20 -O1 -I"$root/include" "$root/examples/emit_shader/main.cpp" -o "$program"
fi
exec "$program" "$@"
