#!/usr/bin/env bash
# Told an older standard, every header says so in its first error, and stops: older_standards.sh COMPILER INCLUDE_DIRECTORY
set -euo pipefail
compiler=$1
cd "$2"
failed=0
for standard in c++17 c++14; do
    # of the older one the umbrellas are enough
    for header in $([[ $standard == c++14 ]] && ls lobe/*.hpp || find lobe -name '*.hpp' ! -name cpp20.hpp); do
        errors=$("$compiler" -std=$standard -x c++ -fsyntax-only -I. "$header" 2>&1 | grep 'error:') || true
        if [[ ${errors%%$'\n'*} != *'lobe needs C++20'* || $(wc -l <<< "$errors") -gt 2 ]]; then
            printf 'FAILED: %s %s\n%s\n' "$header" $standard "$(head -5 <<< "$errors")"
            failed=1
        fi
    done
done
# MSVC says 199711 unless it is told /Zc:__cplusplus, and the truth in another macro.
says() { "$compiler" -U__cplusplus -D__cplusplus="$1" -D_MSVC_LANG="$2" -w -E -x c++ lobe/core/cpp20.hpp > /dev/null 2>&1; }
says 199711L 202002L || { echo "FAILED: MSVC in C++20 is refused"; failed=1; }
! says 199711L 201703L || { echo "FAILED: MSVC in C++17 is not refused"; failed=1; }
exit $failed
