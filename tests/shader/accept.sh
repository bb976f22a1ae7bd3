#!/usr/bin/env bash
# Do compilers of each language take what is printed? accept.sh FOLDER-OF-PRINTED-FILES [c++ compiler]
# A tool that is missing is named; in CI that fails, elsewhere it is skipped (exit code 77).
set -euo pipefail
printed=$(realpath "${1:?the folder of the printed files is missing}")
cxx=${2:-c++}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
failed=0 skipped=0

passed() { echo "ok    $1"; }
wrong() {
    echo "WRONG $1" >&2
    head -n 10 log >&2
    failed=1
}
check() { # name, command
    local name=$1
    shift
    if "$@" >log 2>&1; then passed "$name"; else wrong "$name"; fi
}
missing() { # tool, package
    command -v "$1" >/dev/null && return 1
    echo "SKIPPED: $1 is missing (Debian: apt-get install $2)" >&2
    skipped=1
}
if ! missing glslangValidator glslang-tools && ! missing spirv-val spirv-tools; then
    # calls every function, so that none is dropped before it is validated
    head='^[a-z0-9_]+ ([a-z0-9A-Z_]+)\(vec3 v, vec3 l, vec2 u, float width, float x\).*'
    sed -nE "s/$head/    \\1(vec3(x), vec3(y), vec2(x, y), x, y);/p" "$printed/printed.glsl" >calls.txt
    {
        echo '#version 450'
        cat "$printed/printed.glsl"
        printf 'layout(local_size_x = 1) in;\nlayout(std430, binding = 0) buffer data { float x, y; };\nvoid main() {\n'
        cat calls.txt
        echo '}'
    } >called.comp
    [[ $(wc -l <calls.txt) -gt 100 ]] || { echo "only $(wc -l <calls.txt) functions" >log; wrong "every function is called"; }
    check "GLSL 4.50: glslang" glslangValidator -V called.comp -o glsl.spv
    check "GLSL 4.50: spirv-val" spirv-val glsl.spv
    { printf '#version 300 es\n'; cat "$printed/printed.es.glsl"; echo 'void main() {}'; } >es.frag
    check "GLSL ES 3.00: glslang" glslangValidator es.frag
    {
        cat "$printed/printed.hlsl"
        printf 'RWStructuredBuffer<float> data;\n[numthreads(1, 1, 1)] void main() {\n    float x = data[0], y = data[1];\n'
        sed -E 's/vec3\(x\)/float3(x, x, x)/; s/vec3\(y\)/float3(y, y, y)/; s/vec2/float2/' calls.txt
        echo '}'
    } >all.hlsl
    check "HLSL: glslang" glslangValidator -D -V -S comp -e main all.hlsl -o hlsl.spv
    check "HLSL: spirv-val" spirv-val hlsl.spv
fi

# Metal's names, so that a C++ compiler can read it: the vectors of the printed C++
{
    sed -n '/^#include <cmath>/,/^#endif/p' "$printed/printed.hpp" | grep -vE 'log1p|expm1|erfc'
    echo '#define constant static const'
    echo 'namespace metal { using namespace shading; using float2 = shading::vec2; using float3 = shading::vec3; }'
} >metal_stdlib
check "MSL: $cxx with Metal's names" "$cxx" -std=c++17 -fsyntax-only -I. -x c++ "$printed/printed.metal"

nvcc=$(command -v nvcc || echo /usr/local/cuda/bin/nvcc)
if [[ -x $nvcc ]]; then
    printf '#include "%s"\n__global__ void kernel(float* o, shading::vec3 v) { *o = shading::gltf_all_bounces(v, v, shading::vec2(0, 0), *o, *o).pdf + shading::dfg_read(v, v, shading::vec2(0, 0), *o, *o).bias; }\n' \
        "$printed/printed.cu" >all.cu
    check "CUDA: nvcc" "$nvcc" -std=c++17 -c all.cu -o cuda.o
else
    echo "SKIPPED: nvcc is missing" >&2
fi

((!failed)) || exit 1
((!skipped)) || exit $([[ ${CI:-} ]] && echo 1 || echo 77)
