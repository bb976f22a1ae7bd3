#!/bin/bash
# Usage: scripts/matrix.sh [pattern]: tests/scalars.cpp under each setting, one at a time from -std=c++20 -O2, with each
# compiler that is there. One row a setting, one column a scalar: "ok" and how many assertions, or what failed. A pattern
# takes the rows whose name it matches. Exit 1 if one fails.
set -u
root=$(cd "$(dirname "$0")/.." && pwd)
source "$root/scripts/setup.sh"
need g++ clang libglm-dev catch2 libxsimd-dev
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

scalars=(float double "long double" "xsimd::batch<float>" "xsimd::batch<double>" "scalars::dual" "scalars::archetype")
rows=("-O0" "-O2" "-O3 -march=native" "-O2 -ffast-math" "-O2 -fno-math-errno -fno-trapping-math" "-O2 -ffp-contract=off")
for setting in SIZE_T_LENGTH XYZW_ONLY EXPLICIT_CTOR "DEFAULT_ALIGNED_GENTYPES -DGLM_FORCE_INTRINSICS"; do
    rows+=("-O0 -DGLM_FORCE_$setting")
done
rows+=("-O0 -std=c++23" "-O0 -std=c++26")

# Is it the pack's own exp? That of xsimd 8.1 is a power of 2 under clang's -ffast-math.
exp_of_packs() {
    "$compiler" "${flags[@]}" -Wno-psabi -x c++ - -o "$work/exp" <<'end' && "$work/exp"
#include <xsimd/xsimd.hpp>
int main(int argc, char**) {
    const xsimd::batch<float> e = xsimd::exp(xsimd::batch<float>(-0.1f * static_cast<float>(argc)));
    return e.get(0) > 0.904f && e.get(0) < 0.906f ? 0 : 1;
}
end
}

failed=0
printf '| compiler, setting | %sderivatives |\n' "$(printf "%s | " "${scalars[@]}")"
printf '|---|'; printf -- '---|%.0s' "${scalars[@]}" derivatives; echo
for compiler in g++ clang++; do
    command -v "$compiler" >/dev/null || continue
    launch=($(command -v ccache) "$compiler")
    "${launch[@]}" -std=c++20 -O0 -c "$root/tests/main.cpp" -o "$work/main.o" || exit 1
    for row in "${rows[@]}"; do
        [[ "$compiler $row" =~ ${1:-.} ]] || continue
        read -ra flags <<<"-std=c++20 $row"
        if [[ $row == *-std=* ]]; then
            standard=${row##*-std=}
            [[ $standard == c++23 ]] && standard=c++2b
            [[ $standard == c++26 ]] && standard=c++2c
            flags=(-O0 "-std=$standard")
            "$compiler" "${flags[@]}" -fsyntax-only -x c++ /dev/null 2>/dev/null || {
                echo "| $compiler $row | the compiler does not know it |"
                continue
            }
        fi
        line="| $compiler $row |"
        # uninitialized: said by g++ 12 of its own AVX-512 header
        if "${launch[@]}" "${flags[@]}" -Wall -Wextra -Werror -Wno-psabi -Wno-uninitialized -I"$root/include" -I"$root/tests" \
            -DLOBE_REFERENCE_DIR=\"$root/tests/reference\" \
            -c "$root/tests/scalars.cpp" -o "$work/row.o" 2>"$work/log" &&
            "$compiler" "$work/main.o" "$work/row.o" -o "$work/row" 2>>"$work/log"; then
            for name in "${scalars[@]/#/* - }" "dual numbers differentiate*"; do
                if said=$("$work/row" "$name" 2>&1) && [[ $said =~ \(([0-9]+)\ assertions ]]; then
                    line+=" ok ${BASH_REMATCH[1]} |"
                elif [[ $name == *xsimd* ]] && ! exp_of_packs; then
                    line+=" xsimd's exp is wrong |"
                else
                    line+=" FAILED: $(grep -c 'FAILED:' <<<"$said") |"
                    failed=1
                fi
            done
        else
            line+=" does not compile: $(grep -m 1 error: "$work/log") |"
            failed=1
        fi
        echo "$line"
    done
done
exit $failed
