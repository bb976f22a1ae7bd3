#!/usr/bin/env bash
# Do the loops of docs/integrate.md's batches vectorise? vectorised.sh COMPILER [flags...]: asks the compiler's own report.
set -euo pipefail
compiler=$1
shift
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
folder=$here/../integrate
report=-fopt-info-vec-optimized
! "$compiler" --version | grep -qi clang || report=-Rpass=loop-vectorize
said=$("$compiler" -std=c++20 -O3 -DNDEBUG -fno-math-errno -fno-trapping-math "$report" "$@" -c "$folder/batches.cpp" -o /dev/null 2>&1)
failed=0
for line in $(grep -n 'for (std::size_t' "$folder/batches.hpp" | cut -d: -f1); do
    grep -q "batches.hpp:$line:.*vectorized" <<< "$said" || { echo "FAILED: batches.hpp:$line: not vectorised"; failed=1; }
done
exit $failed
