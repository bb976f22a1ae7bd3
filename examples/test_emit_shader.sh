#!/usr/bin/env bash
# The files of examples/shaders are what emit_shader writes; every part and every function is GLSL that glslang takes; evaluate and
# sample pass verify_shader as they are; wrong words get one line, exit code 2, and nothing is written: test_emit_shader.sh [path/to/emit_shader]
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
source "$root/scripts/setup.sh"
need glslang-tools g++ libglm-dev python3 spirv-cross
program=${1:-$root/examples/emit_shader/run.sh}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

mkdir "$work/shaders"
"$program" --ready-made "$work/shaders"
diff -r "$work/shaders" "$root/examples/shaders" >&2 || { echo "WRONG: examples/shaders is not what emit_shader --ready-made writes" >&2; exit 1; }
echo "ok    $(ls "$work/shaders" | wc -l) ready-made files"

"$program" --functions dfg_texture --texels "$work/texels" --out "$work/texture.glsl"
[[ $(wc -c < "$work/texels") == 8192 ]] && grep -q 'vec2 dfg_uv' "$work/texture.glsl" || { echo "WRONG: --texels" >&2; exit 1; }

accepted() {  # brdf, functions
    "$program" --brdf "$1" --functions "$2" --out "$work/f.glsl"
    { echo '#version 450'; cat "$work/f.glsl"; echo 'void main() {}'; } > "$work/f.frag"
    glslangValidator "$work/f.frag" > "$work/log" || { echo "WRONG: $1"; cat "$work/log"; exit 1; } >&2
}
all=f,f_cos,pdf,evaluate,sample
for normals in ggx ggx_xy beckmann beckmann_xy; do accepted "$normals" $all; done
for masking in smith_correlated smith_separable; do accepted "beckmann $masking" dfg; done
for masking in smith_separable smith_direction_correlated smith_hammon v_cavity; do accepted "ggx $masking" $all; done
for fresnel in schlick_gaussian f82_tint dielectric conductor; do accepted "ggx $fresnel" $all,dfg; done
for sampler in visible_heitz2018 visible_bounded_caps all_normals; do accepted "ggx_xy $sampler" $all; done
for model in lambert oren_nayar fon eon burley burley_frostbite metallic_roughness metallic_roughness_all_bounces; do accepted $model $all; done
echo "ok    every part is GLSL"

# The ready-made files before the judge, as they are: requests stand below them.
judged() { # file of examples/shaders; requests from the standard input
    { echo '#version 450'; cat "$root/examples/shaders/$1.glsl" -; } > "$work/$1.glsl"
}
as_brdf() { # name, prefix, parameters, what the judge is told, like ", isotropic"
    echo "//! verify brdf \"$1\"$4: $2_evaluate(v, l, $3).f_cos"
    echo "//!     sample: direction_sample3 s = $2_sample(v, u, $3); l = s.l; weight = s.weight; pdf = s.pdf"
    echo "//!     pdf: $2_evaluate(v, l, $3).pdf"
}
{
    as_brdf "GGX, alpha 0.3" ggx "0.3, vec3(1.0, 0.71, 0.29)" ", isotropic"
    as_brdf "GGX, alpha 0.01" ggx "0.01, vec3(0.04)" ", isotropic"
    as_brdf "GGX, two widths" ggx_xy "0.1, 0.4, vec3(0.5)" ""
} | judged ggx
as_brdf "glTF" gltf "vec3(1.0, 0.71, 0.29), 0.5, 0.2" ", isotropic" | judged metallic_roughness
"$root/examples/verify_shader/run.sh" "$work"/{ggx,metallic_roughness}.glsl > "$work/log" || { cat "$work/log"; exit 1; } >&2
[[ $(grep -E '^[0-9]+ passed' "$work/log" | xargs) == "3 passed, 0 failed 1 passed, 0 failed" ]] || { cat "$work/log"; exit 1; } >&2
echo "ok    evaluate and sample pass verify_shader"

refused() {  # pattern, arguments
    local pattern=$1 code=0
    shift
    "$program" "$@" --out "$work/none" > "$work/log" 2> "$work/errors" || code=$?
    if [[ $code != 2 || $(wc -l < "$work/errors") != 1 || -s $work/log || -e $work/none ]] || ! grep -q -- "$pattern" "$work/errors"; then
        echo "WRONG $*: exit code $code, $(cat "$work/errors")" >&2
        exit 1
    fi
    echo "ok    $(cat "$work/errors")"
}
refused "did you mean 'glsl'" --language gsl
refused "did you mean 'beckmann'" --brdf "bekman smith_correlated"
refused "did you mean 'smith_correlated'" --brdf "ggx smith_corelated schlick"
refused "did you mean 'evaluate'" --functions evalute
refused "does not go with 'ggx_xy'" --brdf "ggx_xy smith_hammon"
refused "does not go with 'beckmann'" --brdf "beckmann visible_normals"
refused "whole model" --brdf "lambert schlick"
refused "names no part" --brdf ""
refused "'dfg' is of" --brdf lambert --functions dfg
refused "not of 'ggx_xy'" --brdf ggx_xy --functions dfg_table
refused "not of 'v_cavity'" --brdf "ggx v_cavity" --functions dfg
refused "go together" --functions dfg_texture
