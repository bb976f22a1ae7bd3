#!/usr/bin/env bash
# Bakes a small environment and reads the textures with a reader that is not ours, npm's ktx-parse: test_bake_ibl.sh path/to/bake_ibl
# Then bad input and an interruption: one line, exit code 1, nothing left behind.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
source "$root/scripts/setup.sh"
command -v npm >/dev/null || need nodejs npm
program=$(realpath "${1:?the path of bake_ibl is missing}")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

"$program" --size 32 --samples 128 --sh-order 2 --rotate 30 --out baked > log
{ printf '#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 8 +X 16\n'; printf '\200\200\200\201%.0s' {1..128}; } > white.hdr
"$program" white.hdr --size 16 --samples 64 --out white > log
{ printf '#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 8 +X 16\n'; printf '\200\200\200\225%.0s' {1..128}; } > bright.hdr
"$program" bright.hdr --size 16 --samples 64 --out bright > log
grep -q 'above 65504' log || { echo "WRONG: nothing says what halves cannot hold" >&2; exit 1; }
# a sun of one texel in a map 128 times as wide as the cube, against exact solid angles
node -e '
const width = 2048, height = 1024, pixels = Buffer.alloc(4 * width * height);
pixels.set([128, 128, 128, 145], 4 * (301 * width + 1403));
process.stdout.write("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1024 +X 2048\n");
process.stdout.write(pixels);' > sun.hdr
"$program" sun.hdr --size 16 --samples 64 --sh-order 0 --out sun > log
node -e '
const power = 65536 * 2 * Math.PI / 2048 * (Math.cos(301 * Math.PI / 1024) - Math.cos(302 * Math.PI / 1024));
const found = JSON.parse(require("fs").readFileSync("sun/harmonics.json")).radiance[0][0] * Math.sqrt(4 * Math.PI);
if (!(Math.abs(found / power - 1) < 0.01)) { console.error(`WRONG: the energy of a sun, ${found} for ${power}`); process.exit(1); }'
readable=1
npm install --silent --no-audit --no-fund --prefix reader ktx-parse@1.1.0 > npm.log 2>&1 || readable=0
((readable)) || { cat npm.log; echo "SKIPPED: npm could not install ktx-parse, so no other reader has seen the textures" >&2; }
mkdir -p reader
cat > reader/check.mjs <<'end'
import { readFileSync } from 'node:fs';
import { read } from 'ktx-parse';
const half = (h) => {
    const e = (h >> 10) & 31, m = h & 1023, s = h & 32768 ? -1 : 1;
    return s * (e ? (e === 31 ? Infinity : 2 ** (e - 15) * (1 + m / 1024)) : (m / 1024) * 2 ** -14);
};
const halves = (level) => {
    const d = level.levelData, view = new DataView(d.buffer, d.byteOffset, d.byteLength);
    return Array.from({ length: d.byteLength / 2 }, (_, i) => half(view.getUint16(2 * i, true)));
};
const fail = (what) => { console.error('WRONG ' + what); process.exit(1); };
const same = (a, b, what) => { if (a !== b) fail(`${what}: ${a} for ${b}`); };
const near = (a, b, room, what) => { if (!(Math.abs(a - b) <= room)) fail(`${what}: ${a} for ${b}`); };

// the split-sum texture: each half is the float of dfg.raw, rounded
const dfg = read(readFileSync('baked/dfg.ktx2'));
same(dfg.vkFormat, 83, 'vkFormat of dfg'); same(dfg.pixelWidth, 128, 'width'); same(dfg.faceCount, 1, 'faces');
same(dfg.dataFormatDescriptor[0].samples.length, 2, 'samples of the descriptor');
same(dfg.dataFormatDescriptor[0].bytesPlane[0], 4, 'bytes a texel');
const raw = readFileSync('baked/dfg.raw'), terms = halves(dfg.levels[0]);
same(terms.length, 128 * 128 * 2, 'numbers of dfg');
terms.forEach((x, i) => near(x, raw.readFloatLE(4 * i), 2.5e-4, `dfg ${i}`));

// the cube: its levels, and its harmonics as the library has them
const cube = read(readFileSync('baked/prefiltered.ktx2'));
same(cube.vkFormat, 97, 'vkFormat'); same(cube.faceCount, 6, 'faces'); same(cube.levels.length, 3, 'levels');
same(cube.typeSize, 2, 'typeSize'); same(cube.supercompressionScheme, 0, 'compression');
same(cube.dataFormatDescriptor[0].samples[3].channelType & 15, 15, 'channel of alpha');
cube.levels.forEach((level, i) => same(level.levelData.byteLength, 6 * (32 >> i) ** 2 * 8, `bytes of level ${i}`));
const corner = (x, y) => Math.atan2(x * y, Math.sqrt(x * x + y * y + 1));
const projected = (texels, n) => {
    const sums = Array.from({ length: 9 }, () => [0, 0, 0]);
    let whole = 0;
    for (let f = 0; f < 6; ++f) for (let j = 0; j < n; ++j) for (let i = 0; i < n; ++i) {
        const a = (2 * i + 1) / n - 1, b = (2 * j + 1) / n - 1, h = 1 / n;
        const w = [[1, -b, -a], [-1, -b, a], [a, 1, b], [a, -1, -b], [a, -b, 1], [-a, -b, -1]][f];
        const omega = corner(a + h, b + h) - corner(a - h, b + h) - corner(a + h, b - h) + corner(a - h, b - h);
        const r = Math.hypot(...w), [x, y, z] = w.map((c) => c / r);
        const Y = [.28209479, .48860251 * y, .48860251 * z, .48860251 * x, 1.0925484 * x * y, 1.0925484 * y * z,
                   .31539157 * (3 * z * z - 1), 1.0925484 * x * z, .54627422 * (x * x - y * y)];
        whole += omega;
        for (let k = 0; k < 9; ++k) for (let c = 0; c < 3; ++c)
            sums[k][c] += Y[k] * omega * texels[4 * ((f * n + j) * n + i) + c];
    }
    near(whole, 4 * Math.PI, 1e-9, 'solid angles');
    return sums;
};
const json = JSON.parse(readFileSync('baked/harmonics.json')), scale = json.radiance[0][0];
const same_harmonics = (a, b, what) =>
    a.forEach((s, k) => s.forEach((x, c) => near(x, b[k][c], 1e-3 * scale, `${what} ${k}`)));
same_harmonics(projected(halves(cube.levels[0]), 32), json.radiance, 'harmonic of radiance');
// the irradiance is a sum over the lat-long map: the same turn, and Ramamoorthi's factors
const irradiance = read(readFileSync('baked/irradiance.ktx2'));
same_harmonics(projected(halves(irradiance.levels[0]), 32), json.irradiance_over_pi, 'harmonic of irradiance');

// under a uniform light every texel is the same
const white = ['prefiltered', 'irradiance'].flatMap((name) => read(readFileSync(`white/${name}.ktx2`)).levels).flatMap(halves);
white.forEach((x, i) => near(x, white[3], 0, `white ${i}`));  // alpha is 1
console.log('ok    ktx-parse reads the textures; halves and harmonics are the library\'s');
end
if ((readable)); then node reader/check.mjs; fi

refused() {  # pattern, arguments
    local pattern=$1 code=0
    shift
    rm -rf none
    timeout 60 "$program" --out none/below "$@" > /dev/null 2> errors || code=$?
    if [[ $code != 1 || $(wc -l < errors) != 1 || -e none ]] || ! grep -qE -- "$pattern" errors; then
        echo "WRONG $*: exit code $code, $(cat errors)" >&2
        exit 1
    fi
    echo "ok    $(cat errors)"
}
echo nothing > broken.hdr
refused 'broken.hdr' broken.hdr
refused 'missing.hdr' missing.hdr
refused 'size' --size 100
refused 'samples' --samples 0
refused 'size' --size abc
refused 'smallest' --size 16 --smallest 16
refused 'finite' --rotate nan
refused 'finite' --exposure-clamp nan

# a disk that takes no more than so many KiB of a file, in a folder below others that are not there
for kib in 4 40 200; do
    (
        trap '' XFSZ
        ulimit -f $kib
        refused 'cannot be written' --size 64 --samples 4
    ) > log || { cat log; exit 1; }
done
[[ ! -e none ]] || { echo "WRONG: a full disk left $(find none)" >&2; exit 1; }
echo "ok    a full disk leaves nothing"

# interrupted: nothing is left
"$program" --size 512 --samples 4096 --out none/below > /dev/null 2> errors &
sleep 3
kill -INT $! 2> /dev/null || true
wait $! && { echo "WRONG: an interrupted bake ended well" >&2; exit 1; }
[[ ! -e none ]] || { echo "WRONG: an interrupted bake left $(find none)" >&2; exit 1; }
echo "ok    $(cat errors)"
