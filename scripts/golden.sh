#!/usr/bin/env bash
# Writes the golden values, docs/reference/golden.{csv,json}: scripts/golden.sh [--check]. It takes two minutes. --check changes nothing,
# makes those that are no integrals again, in seconds, and fails where they differ.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
source "$root/scripts/setup.sh"
need g++ libboost-dev
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
ccache=$(command -v ccache || true)
$ccache g++ -std=c++20 -O1 -Wall -Wextra -c "$root/tests/golden/generate.cpp" -o "$work/generate.o"
g++ "$work/generate.o" -o "$work/generate"
if [[ ${1:-} == --check ]]; then
    "$work/generate" "$work" points
    for file in golden.csv golden.json; do
        grep -vE '\b[EAB](_average)?\b' "$root/docs/reference/$file" | diff -q - "$work/$file" >/dev/null ||
            { echo "docs/reference/$file is not what tests/golden/generate.cpp writes" >&2; exit 1; }
    done
else
    "$work/generate" "$work"
    cp "$work"/golden.{csv,json} "$root/docs/reference"
fi
