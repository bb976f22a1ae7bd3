#!/usr/bin/env bash
# For any build server: verifies every shader of a folder that asks for it (a comment that begins with "//! verify"): verify_folder.sh FOLDER
# [report.xml]. Exit status: 0 all passed, 1 something failed, 2 a file cannot be read or does not compile, or none asks for anything.
set -euo pipefail
run=$(cd "$(dirname "${BASH_SOURCE[0]}")/../verify_shader" && pwd)/run.sh
folder=${1:?which folder?}
mapfile -d '' -t files < <(grep -rlZE --include='*.'{glsl,vert,frag,comp,rgen,rchit} '^[[:space:]]*//! verify' "$folder" | sort -z)
((${#files[@]})) || { echo "$folder: no shader asks for a verdict" >&2; exit 2; }
exec "$run" --junit "${2:-verify.xml}" -- "${files[@]}"
