#!/usr/bin/env bash
# Runs the printed GLSL and HLSL on a Vulkan device, llvmpipe where there is one: on_device.sh SHADER_WRITE ON_DEVICE [inputs]
# A tool that is missing is named; in CI that fails, elsewhere it is skipped (exit code 77).
set -euo pipefail
write=$(realpath "${1:?the program that prints is missing}")
run=$(realpath "${2:?the program that runs is missing}")
inputs=${3:-1000000}
missing() {
    echo "SKIPPED: $1 is missing (Debian: apt-get install $2)" >&2
    exit $([[ ${CI:-} ]] && echo 1 || echo 77)
}
command -v glslangValidator >/dev/null || missing glslangValidator glslang-tools
driver=$(find /usr/share/vulkan/icd.d -name 'lvp_icd*' 2>/dev/null | head -n 1)
[[ $driver ]] || missing llvmpipe mesa-vulkan-drivers
export VK_ICD_FILENAMES=$driver VK_DRIVER_FILES=$driver

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/glsl" "$work/hlsl"
"$write" kernels GLSL "$work/glsl"
"$write" kernels HLSL "$work/hlsl"
cd "$work/glsl"
printf '%s\0' *.comp | xargs -0 -P 2 -I{} sh -c 'glslangValidator -V "$1" -o "${1%.comp}.spv" >"$1.log" || { cat "$1.log"; exit 1; }' _ {}
cd "$work/hlsl"
printf '%s\0' *.hlsl | xargs -0 -P 2 -I{} sh -c 'glslangValidator -D -V -S comp -e main "$1" -o "${1%.hlsl}.spv" >"$1.log" || { cat "$1.log"; exit 1; }' _ {}
status=0
for language in glsl hlsl; do
    echo "printed as $language:"
    "$run" "$work/$language" $([[ $language == glsl ]] && echo "$inputs" || echo $((inputs / 4))) || status=$?
done
((status != 77)) || [[ ! ${CI:-} ]] || status=1
exit $status
