#!/usr/bin/env python3
"""Prints a GLSL file as C++: glsl_to_cpp.py FILE FOLDER, where FOLDER takes what is made on the way.

The requests become GLSL functions behind the shader; glslang reads all of it, SPIRV-Cross writes it as C++, and `requested()` below that
gives one subject for each request. Exit status 2, with a line that says why, if there is no request, or one or the shader cannot be read.
"""

import difflib
import os
import re
import struct
import subprocess
import sys

file, folder = sys.argv[1:]
shown = re.sub(r'[\x00-\x1f\x7f]', '?', file)


def refuse(why, line=None):
    where = f'{shown}:{line}' if line else shown
    sys.stderr.buffer.write(os.fsencode(f'{where}: {why}\n'.encode('utf-8', 'surrogateescape').decode('utf-8', 'surrogateescape')))
    sys.exit(2)


def read():
    with open(file, 'rb') as f:
        data = f.read()
    for mark, encoding in ((b'\xef\xbb\xbf', 'utf-8-sig'), (b'\xff\xfe\0\0', 'utf-32'), (b'\xff\xfe', 'utf-16'), (b'\xfe\xff', 'utf-16')):
        if data.startswith(mark):
            break
    else:
        encoding = 'utf-8'
    try:
        text = data.decode(encoding, 'replace' if encoding == 'utf-8' else 'strict')  # a comment may be in Latin-1
    except UnicodeDecodeError:
        refuse(f'cannot be read as {encoding}, as its first bytes say')
    if '\0' in text:
        refuse('is not a text (UTF-8, or UTF-16 with a byte order mark)')
    return text.replace('\r\n', '\n').replace('\r', '\n')


# ---- The requests.

KINDS = {  # what a request's expression may use, and its type: in GLSL the functions of the requests are made of these
    'brdf': ('vec3 n, vec3 v, vec3 l', 'vec3'),
    'distribution': ('vec3 n, vec3 m', 'float'),
    'fresnel': ('float cosine', 'vec3'),
    'sequence': ('uint i', 'vec2'),
}
PARTS = {
    ('brdf', 'sample'): ('vec3 n, vec3 v, vec2 u', 'sample'),
    ('brdf', 'pdf'): ('vec3 n, vec3 v, vec3 l', 'float'),
    ('distribution', 'sample'): ('vec3 n, vec2 u', 'vec3'),
    ('distribution', 'pdf'): ('vec3 n, vec3 m', 'float'),
    ('distribution', 'G1'): ('vec3 n, vec3 v', 'float'),
}
MEMBERS = {  # of a subject
    ('brdf', ''): 'f_cos', ('distribution', ''): 'D', ('fresnel', ''): 'F', ('sequence', ''): 'point',
    ('brdf', 'sample'): 'sample_light', ('brdf', 'pdf'): 'pdf_light',
    ('distribution', 'sample'): 'sample_normal', ('distribution', 'pdf'): 'pdf_normal', ('distribution', 'G1'): 'G1',
}
OPTIONS = {
    'lossless': 'options.lossless = true',
    'isotropic': 'options.isotropic = true',
    'not reciprocal': 'options.reciprocal = false',
    'not flat': 'options.flat_at_normal = false',
    'not evenly spread': 'options.low_discrepancy = false',
    'world space': 'world_space = true',
    'thorough': 'options.effort = ::lobe::testkit::effort::thorough',
}
KIND_OF_OPTION = {'not evenly spread': 'sequence', 'points': 'sequence', 'world space': 'brdf', 'not reciprocal': 'brdf', 'not flat': 'fresnel'}


class Function:
    """A request or a part of one: a GLSL function, and the member of its subject that calls it."""

    def __init__(self, line, kind, part, code):
        self.line, self.kind, self.part, self.code = line, kind, part, code
        self.parameters, self.type = PARTS[kind, part] if part else KINDS[kind]
        self.weight = 'vec3'  # its type


class Request(list):
    """The functions of a request: its own, and its parts."""

    def __init__(self, line, kind, name, options):
        super().__init__()
        self.line, self.kind, self.name = line, kind, name
        self.settings = [setting(line, kind, option) for option in map(str.strip, options.split(',')) if option]


def setting(line, kind, option):
    if m := re.fullmatch(r'tolerance\s+((\d+\.?\d*|\.\d+)([eE][-+]?\d+)?)', option):
        return f'options.tolerance = {float(m[1])!r}'
    if m := re.fullmatch(r'points\s+(\d{1,8})', option):
        option, result = 'points', f'points = {int(m[1])}u'
    else:
        option = ' '.join(option.split())
        result = OPTIONS.get(option) or refuse(f"unknown option '{option}'", line)
    if KIND_OF_OPTION.get(option, kind) != kind:
        refuse(f"a {kind} has no option '{option}'", line)
    return result


def close(word, words, cutoff):
    return bool(difflib.get_close_matches(word.lower(), words, 1, cutoff))


def is_nearly_a_request(text):
    """Two of these: a word that is nearly `verify`, one that is nearly a kind, a name in quotes with a colon behind it."""
    words = re.findall(r'\w+', text)[:3]
    return (any(close(w, ['verify'], 0.7) for w in words) + any(close(w, KINDS, 0.7) for w in words) + bool(re.search(r'".*"[^"]*:', text))) >= 2


def requests_of(text):
    requests, last = [], 0
    for comment in re.finditer(r'//(?:\\\n|[^\n])*|/\*.*?(?:\*/|\Z)', text, re.S):
        line = text.count('\n', 0, comment.start()) + 1
        words = re.sub(r'\\\n', '  ', comment[0])
        if not words.startswith('//!'):
            for i, words in enumerate(words.split('\n')):
                if is_nearly_a_request(words) and re.search(r'"[^"]*:', words) and not words.startswith('//-'):
                    refuse('a request that would not be read: it begins with //! (and one that is switched off, with //-)', line + i)
            continue
        words = words[3:].strip()
        follows, last = last + 1 == line and requests, line
        if m := re.fullmatch(r'verify\s+(\w+)\s*"([^"\\]*)"([^:]*):\s*(.+)', words):
            _, kind, name, options, code = m[0], *m.groups()
            if kind not in KINDS:
                refuse(f"cannot verify a '{kind}', only: {', '.join(KINDS)}", line)
            requests.append(Request(line, kind, name, options))
            part = ''
        elif m := re.fullmatch(r'(sample|pdf|G1)\s*:\s*(.+)', words):
            part, code = m.groups()
            if not requests:
                refuse(f"'{part}' before the first 'verify'", line)
            kind = requests[-1].kind
            if (kind, part) not in PARTS:
                refuse(f"a {kind} has no '{part}'", line)
            if part in (f.part for f in requests[-1]):
                refuse(f"a second '{part}' of one request", line)
        else:
            m = re.match(r'(\w*)\s*(:?)', words)
            part_of_some = m[2] and (close(m[1], ['sample'], 0.8) or m[1].lower() in ('pdf', 'g1'))
            if follows or part_of_some or m[1].lower() == 'verify' or is_nearly_a_request(words):
                refuse(f'cannot read this request: {words}', line)
            last = 0  # a comment
            continue
        if '//' in code or '/*' in code:
            refuse('a line holds one request, and no comment in it', line)
        requests[-1].append(Function(line, kind, part, code))
    for r in requests:
        parts = [f.part for f in r]
        if 'pdf' in parts and 'sample' not in parts:
            refuse('a pdf without a sample', r.line)
    if not requests:
        refuse('asks for nothing; write a line such as  //! verify brdf "mine": f(n, v, l) * max(dot(n, l), 0.0)')
    return requests


# ---- As GLSL: each request a function; main() calls the one that is asked for. What C++ sets and reads are globals.

def arguments(f):
    return [parameter.split()[1] for parameter in f.parameters.split(', ')]


def glsl_of(requests):
    globals_, functions, cases = {'lobe_which': 'int'}, [], []
    for r in requests:
        for f in r:
            f.number = len(functions)
            globals_ |= {f'lobe_in_{p.split()[1]}': p.split()[0] for p in f.parameters.split(', ')}
            call = f'lobe_function_{f.number}({", ".join("lobe_in_" + a for a in arguments(f))})'
            if f.type == 'sample':
                globals_ |= {'lobe_light': 'vec3', 'lobe_weight': 'vec3', 'lobe_pdf': 'float'}
                code = f.code if re.search(r'\bweight\b', f.code) else f'{f.code}; if (pdf > 0.0) weight = lobe_function_{r[0].number}(n, v, l) / pdf'
                body = (f'vec3 l = vec3(0.0, 0.0, 1.0); float pdf = 0.0; {f.weight} weight = {f.weight}(0.0); {code}; '
                        'lobe_light = l; lobe_weight = vec3(weight); lobe_pdf = pdf;')
                functions.append((f.line, f'void lobe_function_{f.number}({f.parameters}) {{ {body} }}'))
                cases.append(f'if (lobe_which == {f.number}) {call};')
            else:
                code = f'vec3(({f.code}))' if f.type == 'vec3' else f'({f.code})'
                globals_[f'lobe_out_{f.type}'] = f.type
                functions.append((f.line, f'{f.type} lobe_function_{f.number}({f.parameters}) {{ return {code}; }}'))
                cases.append(f'if (lobe_which == {f.number}) lobe_out_{f.type} = {call};')
    lines = ['#line 1'] + [f'{type_} {name};' for name, type_ in globals_.items()]
    for line, function in functions:
        lines += [f'#line {line}', function]
    return '\n'.join(lines + ['#line 1', 'void lobe_main() {'] + cases + ['}', '']), set(globals_)


# ---- As SPIR-V: made of preprocessed GLSL of one version, in which the shader's inputs are variables that a request may set.

def glslang(arguments_, suffix, text):
    path = f'{folder}/shader.{suffix}'
    with open(path, 'w', encoding='utf-8') as f:
        f.write(text)
    return subprocess.run(['glslangValidator', *arguments_, path], stdin=subprocess.DEVNULL, capture_output=True, text=True, errors='replace')


def first_error(result):
    """Line and words of glslang's first error."""
    lines = (result.stdout + result.stderr).split('\n')
    for line in lines:
        if m := re.match(r'ERROR: (?:.*?shader\.\w+|\d+):(\d+): (.*)', line):
            return int(m[1]), m[2].strip()
    linking = [line.strip() for line in lines if line.startswith('ERROR: Linking')]
    more = [line.strip() for line in lines if line.startswith('    ')]
    return None, ' '.join((linking or ['glslang fails'])[:1] + more[:1])


QUALIFIER = (r'layout\s*\([^()]*\)|uniform|varying|attribute|in|out|inout|buffer|shared|flat|smooth|noperspective|centroid|sample|patch|'
             r'invariant|precise|coherent|volatile|restrict|readonly|writeonly|lowp|mediump|highp|const')
OPAQUE = r'[iu]?(sampler|image|texture|subpassInput)\w*|atomic_uint|accelerationStructure\w+'


def end_of(text, start, opening='{', closing='}'):
    depth = 0
    for m in re.compile('[%s%s]' % (re.escape(opening), re.escape(closing))).finditer(text, start):
        depth += 1 if m[0] == opening else -1
        if depth == 0:
            return m.end()
    return len(text)


def newlines(text):
    return '\n' * text.count('\n')


def with_plain_variables(text):
    """What the pipeline gives to a shader is a variable here: uniforms, inputs, outputs; the blocks of them are structs."""
    out, at = [], 0
    qualified = re.compile(r'(?:\s|^[ \t]*#[^\n]*\n|;)*((?:(?:%s)(?![\w])\s*)*)' % QUALIFIER, re.M)
    while at < len(text):
        m = qualified.match(text, at)
        qualifiers, start = m[1], m.end()
        out.append(text[at:m.start(1)])
        kept = ' '.join(re.findall(r'\b(?:lowp|mediump|highp|const|invariant|precise)\b', qualifiers))
        rest = re.compile(r'(\w*)\s*([{;]?)').match(text, start)
        constant = re.search(r'constant_id', qualifiers)
        if re.search(r'\b(uniform|varying|attribute|in|out|shared)\b', re.sub(r'\([^()]*\)', '', qualifiers)) or constant:
            if rest[2] == ';' or not rest[1] or rest[1].startswith('gl_'):  # layout(...) in;
                start = text.find(';', end_of(text, start) if rest[2] == '{' else start) + 1 or len(text)
                out.append(newlines(text[m.start(1):start]))
                at = start
                continue
            if re.fullmatch(OPAQUE, rest[1]):
                out.append(re.sub(r'\bset\s*=\s*\d+\s*,|,\s*set\s*=\s*\d+|layout\s*\(\s*set\s*=\s*\d+\s*\)', '', qualifiers) if not vulkan(text) else qualifiers)
            elif rest[2] == '{':
                body_end = end_of(text, start)
                body = text[rest.end():body_end - 1]
                body = re.sub(r'\b(layout\s*\([^()]*\)|row_major|column_major|flat|smooth|noperspective|centroid|in|out|uniform)(?!\w)', lambda q: newlines(q[0]), body)
                named = re.compile(r'\s*\w').match(text, body_end)
                if named:
                    out.append(newlines(qualifiers) + 'struct ' + text[start:rest.end()] + body + '}')
                    at = body_end
                else:  # its members are the shader's globals
                    at = text.find(';', body_end) + 1 or len(text)
                    out.append(newlines(text[m.start(1):rest.end()]) + body + newlines(text[body_end:at]))
                    continue
                at = text.find(';', body_end) + 1 or len(text)
                out.append(text[body_end:at])
                continue
            else:
                out.append(newlines(qualifiers) + kept + ' ')
        else:
            out.append(qualifiers)
        # to the end of the declaration or of the function
        stop = re.compile(r'[;{]|\Z').search(text, start)
        if stop[0] == '{':
            at = end_of(text, stop.start())
            if not re.search(r'\)\s*$', text[start:stop.start()]):  # a struct, or a list of initial values
                at = text.find(';', at) + 1 or len(text)
        else:
            at = stop.end()
        out.append(text[start:at])
        if at == m.start():
            break
    return ''.join(out)


def vulkan(text):
    return re.search(r'\blayout\s*\([^()]*\b(set|push_constant|input_attachment_index)\b|\bu?i?texture[123]D\w*\s+\w+\s*;', text)


LATER_KEYWORDS = 'sample patch subroutine precise buffer shared coherent restrict readonly writeonly resource'
EARLIER_NAMES = '''vec4 lobe_FragColor, lobe_FragData[8];
#define gl_FragColor lobe_FragColor
#define gl_FragData lobe_FragData
#define texture2D texture
#define textureCube texture
#define texture2DProj textureProj
#define texture2DLod textureLod
#define textureCubeLod textureLod
#define texture2DLodEXT textureLod
#define textureCubeLodEXT textureLod
'''


def spirv_of(text, requests):
    version = re.search(r'^\s*#\s*version\s+(\d+)(?:\s+(es)\b)?', re.sub(r'//[^\n]*|/\*.*?\*/', '', text, flags=re.S), re.M)
    number, es = (int(version[1]), version[2] or int(version[1]) == 100) if version else (460, None)
    if m := re.search(r'^[ \t]*#[ \t]*include\b', text, re.M):
        refuse('#include is not supported', text.count('\n', 0, m.start()) + 1)
    stage = 'vert' if re.search(r'\bgl_Position\s*=', text) else 'comp' if re.search(r'\blocal_size_[xyz]\b', text) else 'frag'

    glsl, names = glsl_of(requests)
    result = glslang(['-E'], stage, ('' if version else '#version 460\n#line 1\n') + text + '\n' + glsl)
    if result.returncode:
        line, why = first_error(result)
        refuse(f'does not compile: {why}', line)
    code = re.sub(r'^[ \t]*#[ \t]*version\b.*\n', '\n' if version else '', result.stdout, count=1, flags=re.M)
    if es:
        code = re.sub(r'^[ \t]*#[ \t]*extension\b.*', '', code, flags=re.M)
    code = re.sub(r'\bmain\b', 'lobe_main_of_the_shader', code)
    code = re.sub(r'\blobe_main\b', 'main', code)
    if number < 400:
        for word in LATER_KEYWORDS.split():
            if not re.search(r'\b(%s)\s+(in|out|\w+\s+\w+\s*[;{])' % word, code) or word == 'sample':
                code = re.sub(r'\b%s\b' % word, word + '_', code)
    code = with_plain_variables(code)
    head = '#version 460\n' + (EARLIER_NAMES if number < 130 else '') + '#line 1\n'
    if number < 130:  # extensions stand before all code
        code = re.sub(r'^[ \t]*#[ \t]*extension\b.*', '', code, flags=re.M)
    target = ['-V' if vulkan(code) else '-G', '-g', '--quiet', '--auto-map-bindings', '--auto-map-locations', '-o', f'{folder}/shader.spv']
    return glslang(target, stage, head + code), names


def compiled(text, requests):
    """A weight is a vec3, or a float where only that compiles."""
    first = None
    while True:
        result, names = spirv_of(text, requests)
        if not result.returncode:
            break
        line, why = first_error(result)
        first = first or (line, why)
        tried = [f for r in requests for f in r if f.line == line and f.type == 'sample' and f.weight == 'vec3']
        if not tried:
            line, why = first if any(f.line == line for r in requests for f in r if f.type == 'sample') else (line, why)
            refuse(f'does not compile: {why}', line)
        tried[0].weight = 'float'
    with open(f'{folder}/shader.spv', 'rb') as f:
        data = f.read()
    return list(struct.unpack(f'<{len(data) // 4}I', data)), names


UNSUPPORTED = {
    'discard': [252, 4416, 5380],
    'a texture': range(86, 108),
    'dFdx, dFdy or fwidth': range(207, 216),
    'barrier()': [224, 225],
    'an atomic function': range(227, 243),
}


def without_names(words, names):
    """SPIR-V without names but ours, so that none can be one of C++'s; refuses what a function cannot do alone."""
    out, at, line, name_of, outside = words[:5], 5, None, {}, {}
    while at < len(words):
        count, operation = words[at] >> 16, words[at] & 0xffff
        instruction = words[at:at + count]
        at += count
        if operation in (5, 6):  # OpName, OpMemberName
            if operation == 5:
                name = struct.pack(f'<{count - 2}I', *instruction[2:]).split(b'\0')[0].decode('utf-8', 'replace')
                name_of[instruction[1]] = name
            if operation == 6 or name not in names:
                continue
        elif operation == 8:  # OpLine
            line = instruction[2]
        elif operation == 59 and instruction[3] in (0, 1, 2, 3, 9, 12):  # OpVariable of the pipeline
            outside[instruction[2]] = instruction[3]
        for what, operations in UNSUPPORTED.items():
            if operation in operations:
                refuse(f'{what} is not supported', line)
        pointers = {61: instruction[3:4], 62: instruction[1:2], 65: instruction[3:4], 57: instruction[4:]}.get(operation, [])
        for pointer in pointers:
            if pointer in outside:
                name = name_of.get(pointer) or 'gl_... or the members of a block'
                what = {0: 'a texture', 1: 'an input', 3: 'an output'}.get(outside[pointer], 'a buffer block')
                refuse(f"'{name}', {what}, is not supported", line)
        out += instruction
    return out


# ---- As C++.

def cpp_of(words):
    with open(f'{folder}/shader.spv', 'wb') as f:
        f.write(struct.pack(f'<{len(words)}I', *words))
    result = subprocess.run(['spirv-cross', '--cpp', '--emit-line-directives', f'{folder}/shader.spv'], capture_output=True, text=True, errors='replace')
    m = re.search(r'^namespace Impl\n.*?^}\n', result.stdout, re.M | re.S)
    if result.returncode or not m:
        refuse(f'SPIRV-Cross cannot write it as C++: {" ".join(result.stderr.split())}')
    return m[0].replace('std::array<', 'array<').replace('not(', 'not_(')


def literal(text):
    escaped = ''.join(chr(b) if 32 <= b < 127 and b not in b'"\\?' else f'\\{b:03o}' for b in text.encode('utf-8', 'surrogateescape'))
    return f'"{escaped}"'


def subject_of(request):
    yield '{\n::subject s;\nstatic Impl::Shader at;'
    yield f's.options.name = {literal(f"{shown}:{request.line}: {request.name}")};'
    yield from (f's.{setting_};' for setting_ in request.settings)
    for f in request:
        result = '::subject::light_sample{at.lobe_light, at.lobe_weight, at.lobe_pdf}' if f.type == 'sample' else f'at.lobe_out_{f.type}'
        sets = ' '.join(f'at.lobe_in_{a} = {a};' for a in arguments(f))
        yield f's.{MEMBERS[f.kind, f.part]} = []({f.parameters}) {{ {sets} at.lobe_which = {f.number}; at.main(); return {result}; }};'
    yield 'all.push_back(s);\n}'


shader = read()
asked = requests_of(shader)
spirv, named = compiled(shader, asked)
print('#include "glsl.hpp"\nnamespace shader {')
print(cpp_of(without_names(spirv, named)))
print('#line 1 "requests"\nstd::vector<::subject> requested() {\nstd::vector<::subject> all;')
for r in asked:
    print('\n'.join(subject_of(r)))
print('return all;\n}\n}')
