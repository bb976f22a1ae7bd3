#!/usr/bin/env bash
# Builds the library of the judge, then runs a Python file with the module lobe: run.sh [file.py [arguments...]]; without one, demo.py.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$here/../..
source "$root/scripts/setup.sh"
need cmake g++ libglm-dev make python3 python3-numpy
build=$root/build/verify_python
mkdir -p "$root/build"
cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release -DLOBE_BUILD_C_INTERFACE=ON -DLOBE_BUILD_TESTS=OFF -DLOBE_BUILD_EXAMPLES=OFF \
    -DLOBE_BUILD_BENCHMARKS=OFF >"$build.log" 2>&1 || { cat "$build.log" >&2; exit 1; }
cmake --build "$build" --target lobe_verify >"$build.log" 2>&1 || { cat "$build.log" >&2; exit 1; }
(($#)) || set -- "$here/demo.py"
python=python3
python3 -c 'import numpy' 2>/dev/null || python=/usr/bin/python3 # a Python of the user's own, without NumPy, hides Debian's
PYTHONPATH=$here${PYTHONPATH:+:$PYTHONPATH} exec "$python" "$@"
