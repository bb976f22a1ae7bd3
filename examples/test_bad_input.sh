#!/usr/bin/env bash
# Feeds bad files and folders to render_spheres: test_bad_input.sh path/to/render_spheres
# Each must end with exit code 1, within seconds, with one line on stderr that names the culprit and the problem, and leave
# nothing behind.
set -uo pipefail
program=$(realpath "${1:?the path of render_spheres is missing}")
work=$(mktemp -d) errors=$(mktemp)
trap 'rm -rf "$work" "$errors"' EXIT
cd "$work" || exit 1
passed=0 failed=0

# refused WHAT PATTERN ARGUMENTS...: the program ends with an error whose one line names WHAT and matches PATTERN.
refused() {
    local what=$1 pattern=$2 code=0 before after complaint=
    shift 2
    before=$(find . | sort)
    timeout 10 "$program" "$@" >/dev/null 2>"$errors" || code=$?
    after=$(find . | sort)
    [[ $code == 1 ]] || complaint+=" exit code $code;"
    [[ $(wc -l <"$errors") == 1 ]] || complaint+=" not one line;"
    grep -qF -- "$what" "$errors" || complaint+=" does not name $what;"
    grep -qE -- "$pattern" "$errors" || complaint+=" does not say $pattern;"
    [[ $before == "$after" ]] || complaint+=" left something behind;"
    if [[ -z $complaint ]]; then
        passed=$((passed + 1))
        echo "ok    $(cat "$errors")"
    else
        failed=$((failed + 1))
        echo "WRONG $*:$complaint"
        sed 's/^/      /' "$errors"
    fi
}

little_endian() { # value, bytes
    local i
    for ((i = 0; i < $2; ++i)); do printf "\\x$(printf %02x $((($1 >> (8 * i)) & 255)))"; done
}

hdr() { printf '#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y %s +X %s\n' "$2" "$1"; } # width, height
grey() { local i; for ((i = 0; i < $1; ++i)); do printf '\x80\x80\x80\x80'; done; }  # pixels

# An uncompressed OpenEXR file: width, height, name of the first channel, then its pixels as the bits of floats.
exr() {
    local width=$1 height=$2 channel=$3 table y x
    printf 'v/1\x01\x02\0\0\0channels\0chlist\0' && little_endian 55 4
    for name in B G "$channel"; do printf '%s\0' "$name" && little_endian 2 4 && little_endian 0 4 && little_endian 1 4 && little_endian 1 4; done
    printf '\0compression\0compression\0' && little_endian 1 4 && printf '\0'
    for window in dataWindow displayWindow; do
        printf '%s\0box2i\0' $window && little_endian 16 4 && little_endian 0 8 && little_endian $((width - 1)) 4 && little_endian $((height - 1)) 4
    done
    printf 'lineOrder\0lineOrder\0' && little_endian 1 4 && printf '\0'
    printf 'pixelAspectRatio\0float\0' && little_endian 4 4 && little_endian 0x3f800000 4
    printf 'screenWindowCenter\0v2f\0' && little_endian 8 4 && little_endian 0 8
    printf 'screenWindowWidth\0float\0' && little_endian 4 4 && little_endian 0x3f800000 4 && printf '\0'
    shift 3
    (($# > 0)) || return 0
    table=$((313 + 8 * height)) # where the first line starts: after the header and the table of lines
    for ((y = 0; y < height; ++y)); do little_endian $((table + y * (8 + 12 * width))) 8; done
    for ((y = 0; y < height; ++y)); do
        little_endian $y 4 && little_endian $((12 * width)) 4
        for ((x = 0; x < 2 * width; ++x)); do little_endian 0x3f800000 4; done # B and G: 1
        for ((x = 0; x < width; ++x)); do little_endian "$1" 4 && shift; done
    done
}

one=0x3f800000 # the float 1

# Files that are no environment.
refused missing.hdr "does not exist" missing.hdr
mkdir folder.hdr && refused folder.hdr "is not a file" folder.hdr
: >empty.exr && refused empty.exr "is empty" empty.exr
echo "no picture" >text.hdr && refused text.hdr "neither Radiance HDR nor OpenEXR" text.hdr
printf '\x89PNG\r\n\x1a\n0000IHDR' >png.hdr && refused png.hdr "neither Radiance HDR nor OpenEXR" png.hdr

# Radiance HDR.
printf '#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n' >header.hdr && refused header.hdr "truncated" header.hdr
{ hdr 8 4 && grey 20; } >cut.hdr && refused cut.hdr "truncated" cut.hdr
{ hdr 64 32 && printf '\x02\x02\0\x40\x85\x80\x85'; } >cut_runs.hdr && refused cut_runs.hdr "truncated" cut_runs.hdr
{ hdr 64 32 && printf '\x02\x02\0\x40\xff\x80\xff\x80' && grey 2048; } >damaged.hdr && refused damaged.hdr "damaged" damaged.hdr
{ printf '#?RADIANCE\nFORMAT=Radiance_spectra\n\n-Y 4 +X 8\n' && grey 32; } >spectra.hdr && refused spectra.hdr "FORMAT must be .*_rgbe or .*_xyze" spectra.hdr
{ printf '#?RADIANCE\nEXPOSURE=0\n\n-Y 4 +X 8\n' && grey 32; } >exposure.hdr && refused exposure.hdr "EXPOSURE must be above 0" exposure.hdr
{ hdr 6 4 && grey 24; } >shape.hdr && refused shape.hdr "6 x 4 .*twice its height" shape.hdr
hdr 0 0 >zero.hdr && refused zero.hdr "is empty: 0 x 0" zero.hdr
hdr -8 -4 >negative.hdr && refused negative.hdr "is empty: -8 x -4" negative.hdr
hdr 2000000000 1000000000 >huge.hdr && refused huge.hdr "too large" huge.hdr
{ hdr 8 4 && head -c 128 /dev/zero; } >black.hdr && refused black.hdr "holds no light" black.hdr
{ hdr 8 4 && grey 31 && printf '\xff\xff\xff\xff'; } >blinding.hdr && refused blinding.hdr "pixel \(7, 3\) holds 1.*e\+38" blinding.hdr

# OpenEXR.
exr 2 1 R $one $one >good.exr
head -c 200 good.exr >header.exr && refused header.exr "cannot be read.*Early end of file" header.exr
head -c 340 good.exr >cut.exr && refused cut.exr "cannot be read.*Early end of file" cut.exr
exr 2 1 R $one 0x7fc00000 >nan.exr && refused nan.exr "pixel \(1, 0\) holds nan" nan.exr
exr 2 1 R 0x7f800000 $one >infinite.exr && refused infinite.exr "pixel \(0, 0\) holds inf" infinite.exr
exr 2 1 R $one 0xbf800000 >below.exr && refused below.exr "pixel \(1, 0\) holds -1" below.exr
exr 2 1 X $one $one >channels.exr && refused channels.exr "no channels R, G and B, .*only B, G, X" channels.exr
exr 2 2 R $one $one $one $one >square.exr && refused square.exr "2 x 2 .*twice its height" square.exr
exr 0 0 R >zero.exr && refused zero.exr "cannot be read.*Invalid" zero.exr
exr 200000 100000 R >huge.exr && refused huge.exr "exceeds the maximum width of 8192" huge.exr
exr 2147483647 1073741823 R >absurd.exr && refused absurd.exr "cannot be read.*Invalid" absurd.exr

# Folders that cannot take the pictures.
echo "kept" >occupied && refused occupied "cannot be the output folder" good.exr --out occupied
refused /dev/null/out "cannot be the output folder" good.exr --out /dev/null/out
mkdir -p blocked/furnace.png && refused blocked/furnace.png "is a folder" good.exr --out blocked
if [[ $(id -u) != 0 ]]; then
    mkdir sealed && chmod a-w sealed && refused sealed "cannot be written to" good.exr --out sealed
else
    refused /proc "cannot be written to" good.exr --out /proc
fi

# Options.
refused --tile "32 to 512|range" good.exr --tile 1
refused --samples "range" good.exr --samples 0
refused --nonsense "expected|--nonsense" good.exr --nonsense

# And a good file is not refused.
if "$program" good.exr --out out --tile 32 --samples 16 >/dev/null && [[ $(ls -A out | sort | xargs) == "furnace.exr furnace.png glass.exr glass.png glass_furnace.exr glass_furnace.png spheres.exr spheres.png" ]]; then
    passed=$((passed + 1)) && echo "ok    a good file renders"
else
    failed=$((failed + 1)) && echo "WRONG a good file is refused, or its output is incomplete"
fi

echo "$passed passed, $failed failed"
[[ $failed == 0 ]]
