#!/usr/bin/env bash
# clang-format 14, Debian 12's, over every C++ file: scripts/format.sh [--check]. --check changes nothing, and fails where it would.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"
format=$(command -v clang-format-14 || command -v clang-format) || { echo "clang-format is missing (Debian: clang-format-14)" >&2; exit 1; }
"$format" --version | grep -q 'version 14\.' || { echo "clang-format 14 formats this tree; $("$format" --version) differs" >&2; exit 1; }
mapfile -t files < <(git ls-files --cached --others --exclude-standard '*.hpp' '*.cpp' '*.cu')
if [[ ${1:-} == --check ]]; then
    "$format" --dry-run --Werror "${files[@]}"
else
    "$format" -i "${files[@]}"
fi
