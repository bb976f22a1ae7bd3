#!/usr/bin/env bash
# The whole of it, about half an hour: every row on many points, every float of [0,1]; writes docs/accuracy.md. tests/accuracy/run.sh [points] [every n-th float]
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
source "$root/scripts/setup.sh"
need cmake ninja-build g++ libglm-dev catch2 libboost-dev libxsimd-dev
points=${1:-20000} stride=${2:-1}

cd "$root"
cmake --preset gcc --log-level=NOTICE
programs=()
for flags in default vectorize fast_math; do programs+=("accuracy_$flags" "sweep_$flags"); done
cmake --build --preset gcc --target "${programs[@]}"
bin=build/gcc/tests/accuracy
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
failed=0
for flags in default vectorize fast_math; do
    tight=()
    [[ $flags == default ]] && tight=(--tight)
    "$bin/accuracy_$flags" "$points" "${tight[@]}" >"$out/$flags" || failed=1
    # vectorize changes no result (compared below): its sweep would be the default's again
    [[ $flags == vectorize ]] || "$bin/sweep_$flags" "$stride" >"$out/sweep_$flags" || failed=1
done
if ! cmp -s "$out/default" "$out/vectorize"; then
    echo "lobe::vectorize changes a result." >&2
    diff "$out/default" "$out/vectorize" | head -4 >&2
    failed=1
fi
if ((failed)); then
    echo "A promise is broken; docs/accuracy.md is left as it was." >&2
    exit 1
fi

# name | type | region | unit | worst | 99.9 % | mean | worst with -ffast-math | promised | input
paste -d'|' "$out/default" "$out/fast_math" | awk -F' *[|] *' '{
    # every line holds ten fields, twice
    printf "| %s | %s | %s | %s | %s | %s | %s | %s | %s | `%s` |\n", $1, $2, $3, $9, $5, $6, $7, $15, $8, $10 }' >"$out/rows"
tests/accuracy/document.sh "$out/rows" "$out/sweep_default" "$out/sweep_fast_math" "$stride" >"$out/accuracy.md"
mv "$out/accuracy.md" docs/accuracy.md
