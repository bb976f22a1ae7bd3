#!/usr/bin/env bash
# The judge for other languages: the Python module, the demo, C99. Needs what examples/verify_python/run.sh needs.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
source "$here/../scripts/setup.sh"
need gcc
run=$here/verify_python/run.sh
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() { echo "test_verify_python: $1" >&2; exit 1; }

"$run" "$here/verify_python/test_lobe.py" 2>"$work/errors" || { cat "$work/errors" >&2; exit 1; }

"$run" >"$work/demo"
grep -q '^GGX, gold: passed' "$work/demo" || fail "the right BRDF does not pass"
grep -q '^GGX, masked for the viewer alone: FAILED' "$work/demo" || fail "the wrong BRDF passes"
grep -q '^  reciprocity  *FAILED' "$work/demo" || fail "it is not its reciprocity that fails"
mapfile -t seconds < <(sed -n 's/^\([0-9.]*\) s$/\1/p' "$work/demo")
((${#seconds[@]} == 2)) || fail "the demo says no times"

library=$here/../build/verify_python
gcc -std=c99 -Wall -Wextra -Wpedantic -Werror -I"$here/../include" "$here/verify_python/lambert.c" -o "$work/lambert" \
    -L"$library" -llobe_verify -Wl,-rpath,"$library" -lm
"$work/lambert" 0.8 >"$work/c" || fail "C99: 0.8 fails"
status=0
"$work/lambert" 1.2 >"$work/c" || status=$?
[[ $status == 1 ]] && grep -q '^  white furnace is at most 1  *FAILED' "$work/c" || fail "C99: an albedo of 1.2 passes"
echo "verify_python: passed, verdicts of ${seconds[*]} s"
