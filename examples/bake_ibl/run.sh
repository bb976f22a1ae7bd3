#!/usr/bin/env bash
# Builds and runs the baker: examples/bake_ibl/run.sh [environment.hdr|environment.exr] [--out folder] ... (--help lists them).
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
source "$root/scripts/setup.sh"
need cmake ninja-build g++ libglm-dev libopenexr-dev libstb-dev libcli11-dev libtbb-dev fonts-dejavu-core

(cd "$root" && cmake --preset release --log-level=NOTICE && cmake --build --preset release --target bake_ibl)
exec "$root/build/release/examples/bake_ibl" "$@"
