#!/usr/bin/env bash
# Arithmetic of the printed shaders after `spirv-opt -O`, beside textbook shaders of the same terms: size.sh SHADER_WRITE
# Prints the table of docs/shaders.md; exit code 1 where a bar is missed, 77 (in CI 1) where a tool is missing.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
write=$(realpath "${1:?the program that prints is missing}")
for tool in glslangValidator:glslang-tools spirv-opt:spirv-tools python3:python3; do
    command -v "${tool%:*}" >/dev/null && continue
    echo "SKIPPED: ${tool%:*} is missing (Debian: apt-get install ${tool#*:})" >&2
    exit $([[ ${CI:-} ]] && echo 1 || echo 77)
done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/printed"
"$write" kernels GLSL "$work/printed"
counted() { # file
    glslangValidator -V "$1" -o "$work/one.spv" >"$work/log" || { cat "$work/log" >&2; exit 1; }
    spirv-opt -O "$work/one.spv" -o "$work/small.spv"
    spirv-dis --raw-id "$work/small.spv" | python3 "$here/count.py"
}
# Function and bar. D and V alone take sums of squares where a textbook takes 1 - cos^2, so theirs is what was measured: docs/shaders.md.
failed=0
printf '%-22s %8s %9s %6s %6s\n' "" printed textbook ratio bar
while read -r name bar; do
    ours=$(counted "$work/printed/$name.comp") theirs=$(counted "$here/textbook/$name.comp")
    awk -v name="$name" -v ours="$ours" -v theirs="$theirs" -v bar="$bar" 'BEGIN {
        wrong = ours > bar * theirs
        printf "%-22s %8d %9d %6.2f %6.2f%s\n", name, ours, theirs, ours / theirs, bar, wrong ? "  WRONG" : ""
        exit wrong }' || failed=1
done <<'END'
ggx_D 2.13
masking_correlated 1.43
fresnel_schlick_rgb 1.15
facets_evaluate 1.15
facets_sample 1.25
heitz2018_sample 1.25
END
exit $failed
