#!/usr/bin/env bash
# Counts instructions: instructions.sh [--against REVISION | --write | --check]. A table for each compiler: instructions of an element of a plain loop over
# what instructions.cpp lists, as three ways to compile it make them. Counts are exact and repeat to the last digit, so that a busy
# machine does not matter. --against: those of another revision too, from the same program (or that revision's own where the headers
# have other names), and this tree's over them. --write: docs/instructions.md, lobe's counts and their ratio to those of the hand-written
# loops of limit.hpp. --check: fails where a count is more than 3 % above the one that stands there; what another compiler than that of
# the file counts is not judged.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
source "$root/scripts/setup.sh"

case ${1:-} in
    '') against= ;;
    --against) against=$(git -C "$root" rev-parse --verify "${2:?--against what?}^{commit}") ;;
    --write | --check) exec python3 "$root/benchmarks/instructions.py" "$1" "$root/docs/instructions.md" ;;
    *) echo "usage: instructions.sh [--against REVISION | --write | --check]" >&2; exit 1 ;;
esac
need g++ libglm-dev valgrind

fast="-O3 -fno-math-errno -fno-trapping-math"
ways=("-O2" "$fast" "$fast -mavx2 -ffp-contract=off")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trees=("$root")
if [[ $against ]]; then
    mkdir "$work/tree"
    git -C "$root" archive "$against" | tar -x -C "$work/tree"
    trees=("$work/tree" "$root")
fi

# counts COMPILER WAY TREE: lines "name|instructions an element".
counts() {
    local source built='' growth=''
    # As in CMakeLists.txt: GCC stops inlining when a file has grown by 40 %, and what one loop costs would depend on the others.
    [[ $1 != g++ ]] || growth="--param inline-unit-growth=400"
    for source in "$root" "$3"; do
        # shellcheck disable=SC2086  # several flags
        if "$1" -std=c++20 -DNDEBUG $2 $growth -I"$3/include" "$source/benchmarks/instructions.cpp" -o "$work/program" \
            2>>"$work/errors"; then
            built=1
            break
        fi
    done
    [[ $built ]] || { head -n 20 "$work/errors" >&2; return 1; }
    rm -f "$work"/counts* "$work/errors"
    valgrind --quiet --tool=callgrind --combine-dumps=yes --callgrind-out-file="$work/counts" "$work/program"
    sed -n 's/^desc: Trigger: Client Request: //p; s/^totals: /= /p' "$work/counts" |
        awk '$1 != "=" { elements = $1; sub(/^[0-9]+ /, ""); name = $0 }
             $1 == "=" && name { printf "%s|%.1f\n", name, $2 / elements; name = "" }'
}

for compiler in g++ clang++; do
    command -v "$compiler" >/dev/null || continue
    printf '%s\n\n' "$("$compiler" --version | head -1)"
    columns=()
    for way in "${ways[@]}"; do
        [[ $way != *avx2* ]] || grep -qw avx2 /proc/cpuinfo || continue
        echo "  ($((${#columns[@]} / ${#trees[@]} + 1))) $way"
        for tree in "${trees[@]}"; do
            columns+=("$work/${#columns[@]}")
            counts "$compiler" "$way" "$tree" >"${columns[-1]}"
        done
    done
    # Names and their order are this tree's; the other lacks a name where its own program was needed and has it not.
    awk -F'|' -v trees="${#trees[@]}" -v files="${#columns[@]}" '
        FNR == 1 { ++file }
        { value[$1, file] = $2 }
        file == trees { names[++n] = $1 }
        END {
            printf "\n%-28s", "instructions an element"
            for (k = trees; k <= files; k += trees)
                printf trees == 2 ? "  |  (%d) before     after  ratio" : "       (%d)", k / trees
            print ""
            for (j = 1; j <= n; ++j) {
                printf "%-28s", names[j]
                for (k = trees; k <= files; k += trees) {
                    after = value[names[j], k]
                    if (trees == 1) printf "%10s", after
                    else {
                        before = value[names[j], k - 1]
                        printf("  |  %10s%10s%7s", before == "" ? "-" : before, after, before > 0 ? sprintf("%.3f", after / before) : "-")
                    }
                }
                print ""
            }
            print ""
        }' "${columns[@]}"
done
