#!/usr/bin/env bash
# Verifies the functions of GLSL files: run.sh [--all] [--junit report.xml] [file.glsl...]; without files, the three shaders of this folder.
# Prints what failed, with --all every property; --junit writes what build servers read, too. README.md says what a file has to hold.
# Exit status: 0 all passed, 1 something failed, 2 a file is missing, cannot be read or does not compile.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
source "$here/../../scripts/setup.sh"
need g++ libglm-dev glslang-tools python3 spirv-cross
export LC_ALL=C

all=() junit=
while [[ ${1-} == --all || ${1-} == --junit ]]; do
    [[ $1 == --all ]] && all=(--all) && shift && continue
    junit=${2:?--junit needs a file} && shift 2
done
[[ ${1-} == -- ]] && shift
files=("$@")
(($#)) || files=("$here"/{right,tutorial_mistakes,errata}.glsl)

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
compile() { "${CXX:-c++}" -std=c++20 -O2 -w -DGLM_FORCE_SWIZZLE -I"$here" -I"$here/../../include" "$@"; }

refuse() { # why, of the file
    echo "${file//[[:cntrl:]]/?}: $1" >&2
    exit 2
}

verify() ( # file
    file=$1 status=0
    [[ -e $file ]] || refuse "there is no such file"
    [[ ! -d $file ]] || refuse "is a folder"
    [[ -f $file && -r $file ]] || refuse "cannot be read"
    python3 "$here/glsl_to_cpp.py" "$file" "$work" >"$work/shader.cpp" || exit 2
    compile -c "$work/shader.cpp" -o "$work/shader.o" 2>"$work/errors" ||
        refuse "is GLSL, but does not compile as C++: $(sed -nE 's/.*(fatal )?error: //p' "$work/errors" | head -n 1)"
    # The half that is the same for every shader: the test kit.
    [[ -f $work/main.o ]] || compile -c "$here/main.cpp" -o "$work/main.o"
    compile "$work/main.o" "$work/shader.o" -o "$work/verify"

    "$work/verify" "${all[@]}" --junit "$work/report.xml" | sed -E 's/glm::(vec[23]) (\w+)\{([^}]*)\}/\1 \2 = \1(\3)/g' || status=$? # inputs as GLSL writes them
    ((status <= 1)) || refuse "the program that was made of it ended with status $status"
    exit "$status"
)

worst=0 suites=
for file in "${files[@]}"; do
    status=0
    verify "$file" || status=$?
    ((status <= worst)) || worst=$status
    [[ ! $junit || ! -f $work/report.xml ]] || suites+=$(sed '/^<?xml/d; /^<\/\?testsuites>/d' "$work/report.xml")$'\n'
    rm -f "$work/report.xml"
done
[[ ! $junit ]] || printf '<?xml version="1.0" encoding="UTF-8"?>\n<testsuites>\n%s</testsuites>\n' "$suites" >"$junit"
exit "$worst"
