#!/usr/bin/env python3
"""Prints a GLSL file as C++: glsl_to_cpp.py FILE FOLDER, where FOLDER takes what is made on the way.

The requests become GLSL functions behind the shader; glslang reads all of it, SPIRV-Cross writes it as C++, and `requested()` below that
gives one subject for each request. Exit status 2, with a line that says why, if there is no request, or one or the shader cannot be read.
"""

import difflib
import re
import struct
import subprocess
import sys

file, folder = sys.argv[1:]
shown = re.sub(r'[\x00-\x1f\x7f]', '?', file)


def refuse(why, line=None):
    where = f'{shown}:{line}' if line else shown
    sys.stderr.buffer.write(f'{where}: {why}\n'.encode('utf-8', 'surrogateescape'))
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
KIND_OF_OPTION = {  # the others are every kind's
    'not evenly spread': 'sequence', 'points': 'sequence', 'world space': 'brdf', 'not reciprocal': 'brdf', 'not flat': 'fresnel',
}


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


def resembles_request(text):
    """Whether its first words are nearly `verify`, nearly a kind, and whether a colon follows a name in quotes."""
    words = re.findall(r'\w+', text)[:3]
    return any(close(w, ['verify'], 0.7) for w in words), any(close(w, KINDS, 0.7) for w in words), bool(re.search(r'".*"[^"]*:', text))


COMMENT = re.compile(r'//(?:\\\n|[^\n])*|/\*.*?(?:\*/|\Z)', re.S)


def requests_of(text):
    requests, last = [], 0
    for comment in COMMENT.finditer(text):
        line = text.count('\n', 0, comment.start()) + 1
        words = re.sub(r'\\\n', '  ', comment[0])
        if not words.startswith('//!'):
            for i, words in enumerate(words.split('\n')):
                verify, _, named = resembles_request(words)
                if verify and named and not words.startswith('//-'):
                    refuse('a request that would not be read: a request begins with //!, and one that is switched off with //-', line + i)
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
            if follows or part_of_some or m[1].lower() == 'verify' or sum(resembles_request(words)) >= 2:
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
                code = f'vec3 l = vec3(0.0, 0.0, 1.0); float pdf = 0.0; {f.weight} weight = {f.weight}(0.0); {f.code}; '
                if not re.search(r'\bweight\b', f.code):
                    code += f'if (pdf > 0.0) weight = lobe_function_{r[0].number}(n, v, l) / pdf; '
                body = code + 'lobe_light = l; lobe_weight = vec3(weight); lobe_pdf = pdf;'
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

def run(*command):
    return subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True, errors='replace')


def glslang(arguments_, suffix, text):
    path = f'{folder}/shader.{suffix}'
    with open(path, 'w', encoding='utf-8') as f:
        f.write(text)
    return run('glslangValidator', *arguments_, path)


def first_error(result):
    """Its line, and what it says."""
    lines = (result.stdout + result.stderr).split('\n')
    for line in lines:
        if m := re.match(r'ERROR: (?:.*?shader\.\w+|\d+):(\d+): (.*)', line):
            return int(m[1]), f'does not compile: {m[2].strip()}'
    for line, more in zip(lines, lines[1:]):
        if m := re.match(r'ERROR: Linking \w+ stage: (.*)', line):
            return None, f'does not link: {m[1].strip()} {more.strip()}'
    return None, f'does not compile: {" ".join(" ".join(lines).split())}'


WORDS = ('uniform varying attribute in out shared buffer flat smooth noperspective centroid sample patch invariant precise '
         'coherent volatile restrict readonly writeonly lowp mediump highp const row_major column_major').split()
QUALIFIERS = rf'(?:(?:layout\s*\([^()]*\)|\b(?:{"|".join(WORDS)})\b)\s*)'
DECLARATION = re.compile(rf'((?:\s|#[^\n]*|;)*)({QUALIFIERS}*)(\w*)\s*([{{;]?)')
SHAPE = r'(1D|2D|3D|Cube|Buffer|External|_)\w*'
OPAQUE = re.compile(rf'[iu]?(sampler|image|texture){SHAPE}|sampler(Shadow)?|[iu]?subpassInput\w*|atomic_uint|accelerationStructure\w+')
OF_VULKAN = re.compile(rf'\b([iu]?texture{SHAPE}|sampler|samplerShadow|[iu]?subpassInput\w*)\s+\w+\s*[;\[]')


def newlines(match):
    return '\n' * match[0].count('\n')


def end_of_declaration(text, start):
    """Behind the `}` of a function, else behind the `;`."""
    at = re.compile(r'[;{]|\Z').search(text, start).start()
    if text[at:at + 1] != '{':
        return at + 1
    function = text[:at].rstrip().endswith(')')
    depth = 0
    for m in re.compile('[{}]').finditer(text, at):
        depth += 1 if m[0] == '{' else -1
        if not depth:
            return m.end() if function else end_of_declaration(text, m.end())
    return len(text)


def with_plain_variables(text):
    """What the pipeline gives to a shader is a variable here: its uniforms, inputs and outputs; a block of them is a struct."""
    out, at = '', 0
    while at < len(text):
        m = DECLARATION.match(text, at)
        blank, qualifiers, word, then = m.groups()
        at = end_of_declaration(text, m.end(2))
        rest = text[m.end(2):at]
        words = re.sub(r'\([^()]*\)', ' ', qualifiers).split()
        if {'uniform', 'varying', 'attribute', 'in', 'out', 'shared'} & {*words} or 'constant_id' in qualifiers:
            if OPAQUE.fullmatch(word):
                out += blank + re.sub(r'\bset\s*=', 'binding =', qualifiers) + rest  # sets are Vulkan's only
                continue
            if not word or then == ';' or word.startswith('gl_'):  # layout(...) in;
                rest = re.sub(r'(?s).+', newlines, rest)
            elif then == '{':
                rest = re.sub(QUALIFIERS, newlines, rest)
                if re.search(r'}\s*;\Z', rest):  # its members are variables
                    rest = re.sub(r'}\s*;\Z', newlines, re.sub(r'\A\w+\s*{', newlines, rest))
                else:
                    rest = 'struct ' + rest
            qualifiers = re.sub(r'(?s).+', newlines, qualifiers) + ('const ' if 'const' in words else '')
        out += blank + qualifiers + rest
    return out


LATER_KEYWORDS = 'sample|patch|subroutine|precise|buffer|shared|coherent|restrict|readonly|writeonly'
KEYWORD_EXTENSIONS = r'(gpu_shader5|tessellation_shader|compute_shader|shader_(storage|image|subroutine)\w*)'
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
    bare = COMMENT.sub(newlines, text)
    version = re.search(r'^\s*#\s*version\s+(\d+)(\s+es\b)?', bare, re.M)
    number = int(version[1]) if version else 460
    if m := re.search(r'^[ \t]*#[ \t]*include\b', bare, re.M):
        refuse('#include is not supported', bare.count('\n', 0, m.start()) + 1)
    stage = 'vert' if re.search(r'\bgl_Position\b', bare) else 'comp' if re.search(r'\blocal_size_[xyz]\b', bare) else 'frag'

    glsl, names = glsl_of(requests)
    text = re.sub(r'\b__FILE__\b', '0', text)  # for which glslang wants an extension
    preprocessed = glslang(['-E'], stage, ('' if version else '#version 460\n#line 1\n') + text + '\n' + glsl)
    if preprocessed.returncode:
        line, why = first_error(preprocessed)
        refuse(why, line)
    code = re.sub(r'^[ \t]*#[ \t]*version\b.*\n', '\n' if version else '', preprocessed.stdout, count=1, flags=re.M)
    code = re.sub(r'\blobe_main\b', 'main', re.sub(r'\bmain\b', 'lobe_main_of_the_shader', code))
    if not version:
        code = re.sub(r'\bsample(?=\s*\()', 'sample_', code)
    elif (number == 100 or number < 400 and not version[2]) and not re.search(r'#\s*extension\s+\w+_' + KEYWORD_EXTENSIONS, code):
        code = re.sub(rf'\b({LATER_KEYWORDS})\b', r'\1_', code)
    if number < 400:  # what they extend is in 460, or not in a function of a BRDF
        code = re.sub(r'^[ \t]*#[ \t]*extension\b.*', '', code, flags=re.M)
    options = ['-V' if OF_VULKAN.search(code) else '-G', '-g', '--auto-map-bindings', '--auto-map-locations', '-o', f'{folder}/shader.spv']
    code = '#version 460\n' + (EARLIER_NAMES if number < 400 else '') + '#line 1\n' + with_plain_variables(code)
    return glslang(options, stage, code), names


def compiled(text, requests):
    """A weight is a vec3, or a float where only that compiles."""
    while (result_names := spirv_of(text, requests))[0].returncode:
        error = first_error(result_names[0])
        weights = [f for r in requests for f in r if f.type == 'sample' and f.line == error[0]]
        if not weights or weights[0].weight == 'float':
            refuse(weights[0].error if weights else error[1], error[0])
        weights[0].weight, weights[0].error = 'float', error[1]
    with open(f'{folder}/shader.spv', 'rb') as f:
        data = f.read()
    return list(struct.unpack(f'<{len(data) // 4}I', data)), result_names[1]


OP_NAME, OP_MEMBER_NAME, OP_LINE, OP_ENTRY_POINT, OP_EXECUTION_MODE, OP_VARIABLE, OP_DECORATE = 5, 6, 8, 15, 16, 59, 71
FRAGMENT = 4
POINTERS = {57: slice(3, None), 61: slice(2, 3), 62: slice(0, 1), 65: slice(2, 3)}  # OpFunctionCall, OpLoad, OpStore, OpAccessChain
STORAGE = {0: 'a texture', 1: 'a gl_ input', 2: 'a buffer', 3: 'a gl_ output', 12: 'a buffer'}
UNSUPPORTED = {
    'discard': [252, 4416, 5380],
    'a texture': range(86, 108),
    'dFdx, dFdy or fwidth': range(207, 216),
    'barrier()': [224, 225],
    'an atomic function': range(227, 243),
}


def instructions(words):
    at = 5
    while at < len(words):
        count = words[at] >> 16
        yield words[at] & 0xffff, words[at + 1:at + count]
        at += count


def stripped(words, names):
    """SPIR-V without the pipeline, which no function here may use, and without names but ours: C++ has its own reserved ones."""
    name_of, pipeline, line = {}, {}, None
    for operation, operands in instructions(words):
        if operation == OP_NAME:
            name_of[operands[0]] = struct.pack(f'<{len(operands) - 1}I', *operands[1:]).split(b'\0')[0].decode('utf-8', 'replace')
        elif operation == OP_LINE:
            line = operands[1]
        elif operation == OP_VARIABLE and operands[2] in STORAGE:
            pipeline[operands[1]] = STORAGE[operands[2]]
        for what, operations in UNSUPPORTED.items():
            if operation in operations:
                refuse(f'{what} is not supported', line)
        for pointer in operands[POINTERS[operation]] if operation in POINTERS else ():
            if pointer in pipeline:
                named = f' ({name_of[pointer]})' if name_of.get(pointer) else ''
                refuse(f'{pipeline[pointer]}{named} is not supported', line)

    out = words[:5]
    for operation, operands in instructions(words):
        if operation == OP_MEMBER_NAME or operation == OP_NAME and name_of[operands[0]] not in names:
            continue
        if operation == OP_VARIABLE and operands[1] in pipeline or operation == OP_DECORATE and operands[0] in pipeline:
            continue
        if operation == OP_EXECUTION_MODE:
            continue
        if operation == OP_ENTRY_POINT:  # stage, function, its name, the pipeline
            operands = [FRAGMENT, operands[1]] + [word for word in operands[2:] if word not in pipeline]
        out += [len(operands) + 1 << 16 | operation, *operands]
    return out


# ---- As C++.

def cpp_of(words):
    with open(f'{folder}/shader.spv', 'wb') as f:
        f.write(struct.pack(f'<{len(words)}I', *words))
    result = run('spirv-cross', '--cpp', '--emit-line-directives', f'{folder}/shader.spv')
    m = re.search(r'^namespace Impl\n.*?^}\n', result.stdout, re.M | re.S)
    if result.returncode or not m:
        refuse(f'SPIRV-Cross cannot write it as C++: {" ".join(result.stderr.split())}')
    code = m[0].replace('std::array<', 'array<')
    code = re.sub(r'\bnot\(', 'not_(', code)
    constant = re.compile(r'^        const .*;\n', re.M)  # these stand before the structs that they may be of
    return constant.sub('', code).replace('        struct Resources', ''.join(constant.findall(code)) + '        struct Resources', 1)


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
print(cpp_of(stripped(spirv, named)))
print('#line 1 "requests"\nstd::vector<::subject> requested() {\nstd::vector<::subject> all;')
for r in asked:
    print('\n'.join(subject_of(r)))
print('return all;\n}\n}')
