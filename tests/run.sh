#!/usr/bin/env bash
# Builds with warnings as errors and runs the tests: tests/run.sh [gcc] [clang] [sanitize]. Without arguments: gcc and clang.
# `tests/run.sh settings` runs those of other people's flags, macros and compilers alone, with both.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
source "$root/scripts/setup.sh"
need cmake ninja-build g++ clang libglm-dev catch2 libboost-dev libxsimd-dev libgtest-dev glslang-tools spirv-tools libvulkan-dev mesa-vulkan-drivers

presets=("$@")
labels=()
if [[ "$*" == settings ]]; then
    presets=(gcc clang)
    labels=(--label-regex settings)
fi
((${#presets[@]})) || presets=(gcc clang)
[[ " ${presets[*]} " != *" gcc "* ]] || (need git g++-mingw-w64-x86-64-posix) || echo "Without MinGW: <windows.h> is not tested" >&2
[[ " ${presets[*]} " != *" gcc "* ]] || (need g++-aarch64-linux-gnu g++-i686-linux-gnu qemu-user-static) || echo "Without QEMU: aarch64 and i686 are not tested" >&2
if [[ " ${presets[*]} " == *" gcc "* ]]; then
    (need chromium) || echo "Without Chromium: printed WGSL is not run" >&2
    command -v npm >/dev/null || (need nodejs npm) || echo "Without npm: printed WGSL is not run" >&2
fi
[[ " ${presets[*]} " != *" sanitize "* ]] || need libclang-rt-dev

cd "$root"
for preset in "${presets[@]}"; do
    cmake --preset "$preset"
    ((${#labels[@]})) || cmake --build --preset "$preset"
done
failed=0
for preset in "${presets[@]}"; do
    ctest --preset "$preset" --parallel "$(nproc)" "${labels[@]}" || failed=1
done
exit $failed
