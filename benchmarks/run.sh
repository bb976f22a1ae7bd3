#!/usr/bin/env bash
# Builds the benchmarks, runs them and writes docs/tradeoff.md.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
source "$root/scripts/setup.sh"
need cmake ninja-build g++ libglm-dev libbenchmark-dev

cd "$root"
mkdir -p docs
cmake --preset benchmark --log-level=NOTICE
cmake --build --preset benchmark
build/benchmark/benchmarks/trade_report --out docs/tradeoff.md "$@"
