#!/usr/bin/env bash
# Can kernels call all of everything.hpp, and is the rest refused? cuda.sh nvcc|clang COMPILER WORK_DIRECTORY [flags...]; 77: no such compiler.
#
# Two compilers, because neither sees all. nvcc takes a function that is not constexpr for host code; called from one that is, it is dropped
# without a word, and all that follows it. Where it was the whole kernel, the PTX is empty, which is looked for here. Where it was one branch, only
# clang's CUDA mode tells: it needs no CUDA, and names each such call.
set -euo pipefail
mode=$1 compiler=$2 work=$3
shift 3
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
mkdir -p "$work"
failed=0
fail() { echo "FAILED: $*"; failed=1; }
names() { sed -n 's/^EVERYTHING_CALL(\([a-z_0-9A-Z]*\),.*/\1/p' "$here/$1"; }

if [[ $mode == nvcc ]]; then
    compile() { "$compiler" -std=c++20 --expt-relaxed-constexpr -diag-suppress 20012 -arch=sm_80 -ptx "$here/kernels.cu" "${flags[@]}" "$@"; }
    flags=("$@")
    echo '__global__ void kernel() {}' > "$work/control.cu"
    "$compiler" -std=c++20 -arch=sm_80 -ptx "$work/control.cu" -o "$work/control.ptx" || { echo "Skipped: $compiler compiles no kernel"; exit 77; }

    compile -DHOLE -o "$work/kernels.ptx" 2>&1 | tee "$work/log"
    ! grep -qi warning "$work/log" || fail "nvcc warns"
    # Each kernel stores one number and returns.
    awk '/\.entry/ { match($0, /[A-Za-z0-9_]+_(float|double)/); kernel = substr($0, RSTART, RLENGTH) }
         /^\.(weak |visible )?\.?func/ { kernel = "" }
         /st\.global/ { stores[kernel] = 1 }
         /^[ \t]*ret;/ { if (stores[kernel]) print kernel }' "$work/kernels.ptx" | sort > "$work/whole"
    for name in $(names everything.inc); do
        for type in float double; do
            grep -qx "${name}_$type" "$work/whole" || fail "the kernel of $name, $type, has no code"
        done
    done
    ! grep -qx hole_float "$work/whole" || fail "this test does not find the hole"
    ! compile -DHOST_ONLY -o "$work/host.ptx" > "$work/host.log" 2>&1 || fail "host functions compile to kernels"
    for name in $(names host_only.inc); do
        grep -q "calling a __host__ function.*from a __global__ function(\"everything::${name}_kernel\") is not allowed" "$work/host.log" ||
            fail "$name is not refused"
    done
    echo "$(wc -l < "$work/whole") kernels"
else
    compile() {
        "$compiler" -x cuda --cuda-device-only -nocudainc -nocudalib --cuda-gpu-arch=sm_70 -Wno-unknown-cuda-version -std=c++20 -fsyntax-only \
            -ferror-limit=0 -DCLANG "${flags[@]}" "$@" 2>&1
    }
    # clang takes deduction guides for host functions (README): lobe itself uses none of those that are written out, the calls here do.
    errors() { grep 'error:' "$1" | grep -v '^[^ ]*everything\..*deduction guide' || true; }
    flags=("$@")
    printf '%s\n' '#include "cuda_by_clang.hpp"' '#include <cmath>' '#include <cassert>' \
        '__global__ void kernel(double* x) { assert(*x > 0); *x = std::exp(*x); }' > "$work/control.cu"
    compile -I"$here" "$work/control.cu" > "$work/control.log" || { cat "$work/control.log"; echo "Skipped: $compiler checks no kernel"; exit 77; }

    compile "$here/kernels.cu" > "$work/log" || true
    [[ -z $(errors "$work/log") ]] || { errors "$work/log"; fail "these are not constexpr"; }
    compile -DHOLE "$here/kernels.cu" > "$work/hole.log" || true
    [[ $(errors "$work/hole.log") == *"reference to __host__ function 'host_only<float>'"* ]] || fail "this test does not find the hole"
    compile -DHOST_ONLY "$here/kernels.cu" > "$work/host.log" || true
    for name in $(names host_only.inc); do
        line=$(grep -n "EVERYTHING_CALL($name," "$here/host_only.inc" | cut -d: -f1)
        grep -qE "host_only.inc:($line|$((line + 1))):[0-9]+: error: (no matching|reference to __host__)" "$work/host.log" || fail "$name is not refused"
    done
fi
exit $failed
