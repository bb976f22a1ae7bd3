#!/usr/bin/env bash
# A page for every header, from its comments: scripts/reference.sh writes build/reference/html. A warning is an error.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
source "$root/scripts/setup.sh"
need doxygen
cd "$root"
rm -rf build/reference
mkdir -p build/reference
doxygen docs/Doxyfile > build/reference/warnings 2>&1
if [[ -s build/reference/warnings ]]; then
    cat build/reference/warnings >&2
    exit 1
fi
echo "$root/build/reference/html/index.html"
