#!/usr/bin/env bash
# The checks of .clang-tidy over every header.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
source "$root/scripts/setup.sh"
need clang-tidy-14 libglm-dev
cd "$root"
clang-tidy-14 --quiet tests/settings/warnings.cpp -- -std=c++20 -Iinclude
