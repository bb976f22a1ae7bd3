#!/usr/bin/env bash
# Builds and runs the path tracer: examples/path_tracer/run.sh [model.obj] [--environment map] [--out folder] ... (--help lists them).
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
source "$root/scripts/setup.sh"
need cmake ninja-build g++ libglm-dev libopenexr-dev libstb-dev libcli11-dev libtbb-dev fonts-dejavu-core libembree-dev libtinyobjloader-dev

(cd "$root" && cmake --preset release --log-level=NOTICE && cmake --build --preset release --target path_tracer)
exec "$root/build/release/examples/path_tracer" "$@"
