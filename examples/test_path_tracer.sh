#!/usr/bin/env bash
# Builds the path tracer and its test: test_path_tracer.sh [pictures]. A furnace, and a scene by three ways to find its light, whose means
# agree within their noise; 24 pictures each way unless told. Then bad input and an interruption: one line, exit code 2, nothing left behind.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
source "$root/scripts/setup.sh"
need cmake ninja-build g++ libglm-dev libopenexr-dev libstb-dev libcli11-dev libtbb-dev fonts-dejavu-core libembree-dev libtinyobjloader-dev
(cd "$root" && cmake --preset release --log-level=NOTICE >/dev/null && cmake --build --preset release --target path_tracer test_path_tracer)
examples=$root/build/release/examples program=$examples/path_tracer
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

"$examples/test_path_tracer" "$@" > log || { cat log; exit 1; }
grep -v ' paths ' log

small=(--width 16 --height 10 --samples 2)
"$program" "${small[@]}" --threads 1 --out one > /dev/null
"$program" "${small[@]}" --threads 2 --out two > /dev/null
[[ $(ls -A one | xargs) == "path_tracer.exr path_tracer.png" ]] || { echo "WRONG: wrote $(ls -A one)" >&2; exit 1; }
cmp one/path_tracer.exr two/path_tracer.exr
echo "ok    one thread and two render the same"

folder=none/below
refused() {  # pattern, arguments
    local pattern=$1 code=0
    shift
    rm -rf none
    timeout 60 "$program" "${small[@]}" "$@" --out "$folder" > /dev/null 2> errors || code=$?
    if [[ $code != 2 || $(wc -l < errors) != 1 || -e none ]] || ! grep -qE -- "$pattern" errors; then
        echo "WRONG $*: exit code $code, $(cat errors)" >&2
        exit 1
    fi
    echo "ok    $(cat errors)"
}
face='v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n'
obj() { printf "$2" > "$1"; }  # file, text
mtl() { printf "newmtl m\n$2\n" > "$1.mtl" && obj "$1.obj" "mtllib $1.mtl\nusemtl m\n$face"; }

refused 'missing.obj: does not exist' missing.obj
mkdir folder.obj && refused 'folder.obj: is not a file' folder.obj
: > empty.obj && refused 'empty.obj: has no faces' empty.obj
echo nothing > text.obj && refused 'text.obj: has no faces' text.obj
cp one/path_tracer.png noise.obj && refused 'noise.obj: ' noise.obj
obj few.obj 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n' && refused 'few.obj: .*not there' few.obj
obj far.obj 'v 0 0 0\nv 1 0 0\nv 0 1e30 0\nf 1 2 3\n' && refused 'far.obj: a point is not finite' far.obj
obj flat.obj 'v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n' && refused 'flat.obj: has no faces with an area' flat.obj
mtl gain 'Kd 2 0 0' && refused 'gain.obj: .*Kd.* of its material m is 2' gain.obj
mtl dark 'Ke -1 0 0' && refused 'dark.obj: .*Ke' dark.obj
mtl rough 'Pr 7' && refused 'rough.obj: .*Pr' rough.obj
mtl thin 'illum 7\nNi 0.1' && refused 'thin.obj: .*Ni' thin.obj
mtl picture 'Kd 1 1 1\nmap_Kd none.png' && refused 'picture.obj: its texture none.png cannot be read' picture.obj
echo nothing > broken.hdr
refused 'broken.hdr' --environment broken.hdr
refused 'missing.exr' --environment missing.exr
refused 'samples' --samples 0
refused 'width' --width abc
refused 'directions' --directions light
refused 'exposure' --exposure nan
echo kept > occupied
folder=occupied refused 'occupied: cannot be the output folder'

# a texture, a light and glass of a model's own
cp one/path_tracer.png checks.png
mtl textured 'map_Kd checks.png\nKe 1 1 1' && "$program" "${small[@]}" textured.obj --out textured > /dev/null
mtl frosted 'illum 7\nNi 1.5\nPr 0.4' && "$program" "${small[@]}" frosted.obj --out frosted > /dev/null
echo "ok    models with a texture, and of rough glass"

"$program" --width 2000 --height 2000 --samples 64 --out none/below > /dev/null 2> errors &
sleep 1
kill -INT $! 2> /dev/null || true
code=0; wait $! || code=$?
[[ $code == 2 && ! -e none && $(wc -l < errors) == 1 ]] || { echo "WRONG: interrupted: exit code $code, $(cat errors) $(ls)" >&2; exit 1; }
echo "ok    $(cat errors)"
