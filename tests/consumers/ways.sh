#!/usr/bin/env bash
# Projects that use lobe in other ways than a target: precompiled, in one unit, in two with link-time optimisation, by pkg-config, by -I, as one
# file; and what an install puts where, and leaves when it is undone: tests/consumers/ways.sh [build directory] [compiler]
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)
work=${1:-$root/build/ways}
compiler=${2:-g++}
rm -rf "$work"
mkdir -p "$work"
cd "$work"

quietly() {
    "$@" > log 2>&1 || { cat log; echo "FAILED: $*" >&2; exit 1; }
}

options=(-G Ninja -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_BUILD_TYPE=Release)
quietly cmake -S "$root" -B lobe "${options[@]}" -DLOBE_BUILD_TESTS=OFF -DLOBE_BUILD_EXAMPLES=OFF -DLOBE_BUILD_BENCHMARKS=OFF
quietly cmake --install lobe --prefix "$work/prefix"

quietly cmake -S "$here/ways" -B project "${options[@]}" -DCMAKE_PREFIX_PATH="$work/prefix"
quietly cmake --build project
for program in precompiled unity two_units judged; do quietly "project/$program"; done

flags=(-std=c++20 -O1 -Wall -Wextra -Werror)
if command -v pkg-config > /dev/null; then
    read -ra found < <(PKG_CONFIG_PATH="$work/prefix/share/pkgconfig" pkg-config --cflags lobe)
    quietly "$compiler" "${flags[@]}" "${found[@]}" "$here"/ways/{main,other}.cpp -o by_pkg_config
    quietly ./by_pkg_config
fi
quietly "$compiler" "${flags[@]}" -I"$root/include" "$here"/ways/{main,other}.cpp -o by_path
quietly ./by_path

quietly python3 "$root/scripts/single_header.py" single/lobe
mv single/lobe/lobe_testkit.hpp single/lobe/testkit.hpp
quietly "$compiler" "${flags[@]}" -Isingle "$here"/ways/{main,other}.cpp -o one_file
quietly ./one_file
quietly "$compiler" "${flags[@]}" -Isingle "$here"/ways/judged.cpp -o one_file_judged
quietly ./one_file_judged

# Headers, CMake's and pkg-config's files, the licence: nothing else, and nothing is left.
others=$(cd prefix && find . -type f | grep -Ev '^\./(include/lobe/.*\.hpp|include/lobe/testkit/c\.h|share/cmake/lobe/lobe[A-Za-z]+\.cmake|share/pkgconfig/lobe\.pc|share/doc/lobe/LICENSE)$' || true)
[[ -z $others ]] || { echo "FAILED: installed as well: $others" >&2; exit 1; }
quietly cmake -P "$root/scripts/uninstall.cmake" lobe/install_manifest.txt
[[ ! -e prefix ]] || { echo "FAILED: left by the uninstaller: $(find prefix)" >&2; exit 1; }
