#!/usr/bin/env bash
# The printed WGSL run in Chromium's WebGPU, the GLSL ES in its WebGL 2, both headless on SwiftShader: browser.sh SHADER_WRITE
# What is missing is named, and the test skipped (exit code 77), in CI it fails: Chromium (Debian: chromium), node, playwright-core (npm, fetched).
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
write=$(realpath "${1:?the program that prints is missing}")
skip() {
    echo "SKIPPED: $1" >&2
    exit $([[ ${CI:-} ]] && echo 1 || echo 77)
}
chromium=$(command -v chromium) || skip "chromium is missing (Debian: apt-get install chromium)"
command -v node >/dev/null || skip "node is missing (Debian: apt-get install nodejs)"
command -v npm >/dev/null || skip "npm is missing (Debian: apt-get install npm)"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export HOME=$work
(cd "$work" && timeout 30 npm install --no-audit --no-fund --silent playwright-core@1 >/dev/null 2>&1) || skip "npm does not give playwright-core"
"$write" browser "$work"
"$write" "GLSL ES" "$work/printed.es.glsl"
timeout 100 node "$here/browser.mjs" "$work" "$chromium" "$work/node_modules/playwright-core"
