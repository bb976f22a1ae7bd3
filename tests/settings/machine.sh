#!/usr/bin/env bash
# The accuracy rows in another machine's arithmetic, run by QEMU: machine.sh NAME INSTRUCTION INPUTS WORK ROOT BOOST_INCLUDE_DIR INCLUDES...
# aarch64, where g++ contracts products and sums to fma unless told not to; i686, whose registers hold 80 bits. INSTRUCTION: one that shows it.
set -euo pipefail
machine=$1 instruction=$2 inputs=$3 work=$4 root=$5 boost=$6
shift 6
qemu=qemu-${machine/i686/i386}-static
rm -rf "$work"
mkdir -p "$work/boost"
ln -s "$boost/boost" "$work/boost/boost"
cd "$work"
compile() { "$machine-linux-gnu-g++" -std=c++20 -O2 -DGLM_FORCE_XYZW_ONLY -I"$root/tests/accuracy" "$@"; }
[[ $machine == i686 ]] && exact=(-msse2 -mfpmath=sse) || exact=(-ffp-contract=off)
compile "$@" -isystem boost "${exact[@]}" -c "$root/tests/accuracy/truth.cpp" -o truth.o
compile "$@" -fPIC -shared -fvisibility=hidden -fvisibility-inlines-hidden "$root/tests/accuracy/values.cpp" -o libvalues.so
compile "$@" "$root/tests/accuracy/main.cpp" truth.o -L. -lvalues -Wl,-rpath,"$work" -pthread -o accuracy
[[ $("$machine-linux-gnu-objdump" -d libvalues.so) == *"$instruction"* ]] || { echo "FAILED: no $instruction, so this tests nothing" >&2; exit 1; }
"$qemu" -L "/usr/$machine-linux-gnu" ./accuracy "$inputs"
