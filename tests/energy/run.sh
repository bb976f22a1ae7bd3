#!/usr/bin/env bash
# Writes docs/energy.md and docs/energy.svg: the models of multiple scattering measured against the random walk. A quiet machine, for the times.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
source "$root/scripts/setup.sh"
need g++ libglm-dev gnuplot-nox fonts-dejavu-core
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT

g++ -std=c++20 -O2 -DNDEBUG -I"$root/include" -DLOBE_REFERENCE_DIR="\"$root/tests/reference\"" "$root/tests/energy/main.cpp" -o "$out/energy_models"
"$out/energy_models" "$out" >"$out/tables"
gnuplot -e "data='$out'; out='$out/energy.svg'" "$root/tests/energy/plot.gnuplot"

# the tables, in order, in place of their names
awk -v RS= -v folder="$out" '{ print > (folder "/table" NR) }' "$out/tables"
sed -e "/@MODELS@/{r $out/table1
d}" -e "/@BRDFS@/{r $out/table2
d}" -e "/@WEIGHTS@/{r $out/table3
d}" "$root/tests/energy/energy.md.in" >"$out/energy.md"
mv "$out/energy.md" "$out/energy.svg" "$root/docs/"
