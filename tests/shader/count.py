#!/usr/bin/env python3
"""Arithmetic operations on floats in SPIR-V assembly (standard input), each component of a vector counted; min, max, abs, choices and
comparisons too. A dot of n is 2n - 1, normalize 2n + 1, reflect and cross 9; sqrt, sin, cos, a division: 1."""
import re
import sys

width, kind, total = {}, {}, 0
EXTENDED = {'Normalize': lambda n: 2 * n + 1, 'Reflect': lambda n: 9, 'Cross': lambda n: 9, 'Length': lambda n: 2 * n}
for line in sys.stdin:
    m = re.match(r'\s*(%\d+) = (Op\w+)\s*(.*)', line)
    if not m:
        continue
    result, operation, operands = m[1], m[2], m[3].split()
    if operation in ('OpTypeFloat', 'OpTypeBool'):
        width[result] = 1
    elif operation == 'OpTypeVector' and operands[0] in width:
        width[result] = int(operands[1])
    if not operands or operands[0] not in width:
        continue
    n = width[operands[0]]
    kind[result] = n
    if operation == 'OpDot':
        total += 2 * kind.get(operands[1], 3) - 1
    elif operation == 'OpExtInst':
        total += EXTENDED.get(operands[2], lambda k: k)(kind.get(operands[3], n) if operands[2] in EXTENDED else n)
    elif re.match(r'OpF(Add|Sub|Mul|Div|Negate|Ord|Unord)|OpVectorTimesScalar|OpSelect|OpLogical|OpFConvert', operation):
        total += n
print(total)
