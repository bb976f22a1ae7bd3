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
const texels = halves(cube.levels[0]), n = 32, sums = Array.from({ length: 9 }, () => [0, 0, 0]);
const corner = (x, y) => Math.atan2(x * y, Math.sqrt(x * x + y * y + 1));
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
const json = JSON.parse(readFileSync('baked/harmonics.json')), scale = json.radiance[0][0];
sums.forEach((s, k) => s.forEach((x, c) => near(x, json.radiance[k][c], 1e-3 * scale, `harmonic ${k}`)));
console.log('ok    ktx-parse reads dfg.ktx2 and prefiltered.ktx2; halves and harmonics are the library\'s');
end
if ((readable)); then node reader/check.mjs; fi

refused() {  # pattern, arguments
    local pattern=$1 code=0
    shift
    rm -rf none
    timeout 60 "$program" --out none "$@" > /dev/null 2> errors || code=$?
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
refused 'smallest' --size 16 --smallest 32

# interrupted: nothing is left
"$program" --size 512 --samples 4096 --out none > /dev/null 2> errors &
sleep 3
kill -INT $! 2> /dev/null || true
wait $! && { echo "WRONG: an interrupted bake ended well" >&2; exit 1; }
[[ ! -e none ]] || { echo "WRONG: an interrupted bake left $(find none)" >&2; exit 1; }
echo "ok    $(cat errors)"
