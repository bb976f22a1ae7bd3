#!/usr/bin/env bash
# docs/accuracy.md from what was measured: document.sh ROWS SWEEP SWEEP_FAST_MATH STRIDE
set -euo pipefail
rows=$1 sweep=$2 sweep_fast_math=$3
every="every "
(($4 == 1)) || every="every $4-th "
cat "$(dirname "${BASH_SOURCE[0]}")/preface.md"
cat <<END
## Summary

The worst of all regions, in the row's unit; what is promised of angles and distances in float, in double 2^29 times less.

| function | unit | promised | float | double | float, \`-ffast-math\` | double, \`-ffast-math\` |
|:--|:--|--:|--:|--:|--:|--:|
END
awk -F' *[|] *' '
    !($2 in unit) { name[++n] = $2; unit[$2] = $5; promised[$2] = $10 }
    { if ($6 + 0 > worst[$2, $3] + 0) worst[$2, $3] = $6; if ($9 + 0 > fast[$2, $3] + 0) fast[$2, $3] = $9 }
    END { for (i = 1; i <= n; ++i) { k = name[i]
        printf "| %s | %s | %s | %s | %s | %s | %s |\n", k, unit[k], promised[k], worst[k, "float"], worst[k, "double"], fast[k, "float"], fast[k, "double"] } }' "$rows"
cat <<END

## Every float

u runs over ${every}float of [0,1]; the radical inverse over ${every}index of 32 bits. The truth is the formula in double.

| function of u | values | worst | mean | \`-ffast-math\` | promised | worst u |
|:--|--:|--:|--:|--:|--:|:--|
END
paste -d'|' "$sweep" "$sweep_fast_math" | awk -F' *[|] *' '{ printf "| %s | %s | %s | %s | %s | %s | %s |\n", $1, $2, $3, $4, $9, $5, $6 }'
cat <<END

## Every region

| function | type | region | unit | worst | 99.9 % | mean | \`-ffast-math\` | promised | worst input |
|:--|:--|:--|:--|--:|--:|--:|--:|--:|:--|
END
cat "$rows"
