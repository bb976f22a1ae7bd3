#!/usr/bin/env python3
"""Writes the table of instruction counts, or compares this tree's with it: instructions.py --write|--check docs/instructions.md.

Counts are those that instructions.sh prints. A rise of more than 3 % fails, and so does a row that is gone.
"""
import pathlib
import re
import subprocess
import sys

ROOM = 1.03
TENTH = 0.1  # counts are printed to a tenth
LIMIT = "limit: "
WAYS = ("-O2", "SSE2", "AVX2")


def counted():
    """{compiler: {name: [instructions an element, each way]}} of this tree."""
    script = pathlib.Path(__file__).with_name("instructions.sh")
    text = subprocess.run(["bash", str(script)], check=True, capture_output=True, text=True).stdout
    tables, current = {}, None
    for line in text.splitlines():
        row = re.match(r"(\S.*?)((?:\s+[0-9]+\.[0-9])+)$", line)
        if row and current is not None:
            current[row[1]] = [float(x) for x in row[2].split()]
        elif re.search(r"[0-9]+\.[0-9]+\.[0-9]+", line):
            current = tables.setdefault(line.strip(), {})
    if not tables or not all(tables.values()):
        sys.exit("instructions.sh printed no table")
    return tables


def written(path):
    tables, current = {}, None
    for line in path.read_text().splitlines():
        if line.startswith("## "):
            current = tables.setdefault(line[3:], {})
        cells = [c.strip() for c in line.strip("|").split("|")]
        if current is not None and line.startswith("| ") and re.match(r"[0-9]", cells[1]):
            current[cells[0]] = [float(x) for x in cells[1:4]]
    return tables


def page(tables):
    text = """# Instructions of an element

Of a plain loop over arrays of components, by callgrind: exact, so that a busy machine does not matter. `-O2`; SSE2:
`-O3 -fno-math-errno -fno-trapping-math`, which is `lobe::vectorize`; AVX2: the same with `-mavx2 -ffp-contract=off`. Over the limit: lobe's
count over that of the hand-written loop of `benchmarks/limit.hpp`, which has no guards. Times are in [tradeoff.md](tradeoff.md).

`bash benchmarks/instructions.sh --write` writes this file, and CI's `--check` fails where a count rises by more than 3 %.
"""
    for compiler, rows in tables.items():
        text += f"\n## {compiler}\n\n| loop | {' | '.join(WAYS)} | over the limit: {' | '.join(WAYS)} |\n|:---|" + "---:|" * 6 + "\n"
        for name, counts in rows.items():
            if name.startswith(LIMIT):
                continue
            best = rows.get(LIMIT + name)
            ratios = [f"{a / b:.2f}" for a, b in zip(counts, best)] if best else [""] * len(counts)
            text += f"| {name} | {' | '.join(f'{c:.1f}' for c in counts)} | {' | '.join(ratios)} |\n"
    return text


def check(tables, stored):
    judged, worse = 0, []
    for compiler, rows in tables.items():
        for name, before in stored.get(compiler, {}).items():
            judged += 1
            after = rows.get(name)
            if after is None:
                worse.append(f"{compiler}: {name} is not counted any more")
                continue
            worse += [
                f"{compiler}, {way}: {name} takes {a:.1f} instructions, {a / b:.3f} of {b:.1f}"
                for way, a, b in zip(WAYS, after, before)
                if a > b * ROOM + TENTH
            ]
    return judged, worse


def main():
    path = pathlib.Path(sys.argv[2])
    tables = counted()
    if sys.argv[1] == "--write":
        path.write_text(page(tables))
        return
    judged, worse = check(tables, written(path))
    if not judged:
        print(f"instructions: {path.name} knows none of these compilers, nothing was judged: {', '.join(tables)}")
    if worse:
        print("\n".join(worse))
        sys.exit("instructions rose by more than 3 %; if that is what they have to cost: bash benchmarks/instructions.sh --write")
    print(f"instructions: {judged} loops, none takes 3 % more than docs/instructions.md says")


main()
