#!/usr/bin/env bash
# Writes docs/ibl.svg and prints its table: filtered against unfiltered importance sampling of a map: tests/ibl/run.sh MAP.hdr
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
source "$root/scripts/setup.sh"
need g++ pkg-config libglm-dev libopenexr-dev gnuplot-nox fonts-dejavu-core
map=${1:?a lat-long map, Radiance HDR or OpenEXR}
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT

common=$root/examples/common
read -ra exr < <(pkg-config --cflags --libs OpenEXR)
g++ -std=c++20 -O2 -DNDEBUG -I"$root/include" "$root/tests/ibl/main.cpp" \
    "$common"/{environment,radiance_hdr,open_exr,colour}.cpp "${exr[@]}" -o "$out/prefilter_curves"
"$out/prefilter_curves" "$map" "$out"
gnuplot -e "data='$out'; out='$out/ibl.svg'" "$root/tests/ibl/plot.gnuplot"
mv "$out/ibl.svg" "$root/docs/"
