#!/usr/bin/env python3
"""Writes lobe.hpp and lobe_testkit.hpp, each one file that needs GLM alone: scripts/single_header.py FOLDER.

The second includes nothing of the first but what it needs itself: both may be included in one file."""
import pathlib
import re
import sys

root = pathlib.Path(__file__).resolve().parent.parent
include = re.compile(r'#include <(lobe/[^>]+)>.*')


def bundle(start, licence, version):
    parts, seen, outside = [], set(), []

    def add(name):
        if name in seen:
            return
        seen.add(name)
        lines = []
        for line in (root / 'include' / name).read_text().splitlines():
            found = include.match(line)
            if line == '#pragma once':
                continue
            if found and found[1] != 'lobe/this_is_not_cpp20':
                add(found[1])
            elif re.match(r'#include <', line) and 'this_is_not_cpp20' not in line:
                if line not in outside:
                    outside.append(line)
            else:
                lines.append(line)
        guard = 'LOBE_INCLUDED_' + re.sub(r'\W', '_', name).upper()
        body = re.sub(r'\n{3,}', '\n\n', '\n'.join(lines)).strip('\n')
        parts.append(f'#ifndef {guard}\n#define {guard}\n// ---- {name}\n{body}\n#endif\n')

    add(start)
    # what is not lobe's stands below the check of the standard, which is the first part
    head, *rest = parts
    comment = ''.join(f'// {line}'.rstrip() + '\n' for line in licence.splitlines())
    return f'// lobe {version}: {start} and what it includes, in one file.\n//\n{comment}#pragma once\n\n{head}\n' + \
        '\n'.join(sorted(outside)) + '\n\n' + '\n'.join(rest)


def main():
    if len(sys.argv) != 2:
        sys.exit('scripts/single_header.py FOLDER')
    out = pathlib.Path(sys.argv[1])
    numbers = re.findall(r'#define LOBE_VERSION_\w+ (\d+)', (root / 'include/lobe/version.hpp').read_text())
    licence = (root / 'LICENSE').read_text()
    out.mkdir(parents=True, exist_ok=True)
    for start, name in ('lobe/lobe.hpp', 'lobe.hpp'), ('lobe/testkit.hpp', 'lobe_testkit.hpp'):
        (out / name).write_text(bundle(start, licence, '.'.join(numbers)))


main()
