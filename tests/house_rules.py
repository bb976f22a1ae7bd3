#!/usr/bin/env python3
"""The rules of docs/design.md that can be read off the source. Run from anywhere; exit 1 if a rule is broken.

A line that breaks a rule for a good reason carries `house:` and the reason in a comment.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
HEADERS = ROOT / "include/lobe"
WIDTH = 120

# Which rooms a room may include, beside itself. Rooms inside the kit are written testkit/room; "" is include/lobe itself.
BASE = {"core", "numeric"}
MODELS = BASE | {"width", "sampling", "ndf", "fresnel", "brdf"}
MAY_INCLUDE = {
    "core": set(),
    "numeric": {"core"},
    "sampling": BASE,
    "fresnel": BASE,
    "width": BASE,
    "ndf": BASE | {"width", "sampling"},
    "brdf": MODELS,
    "bsdf": MODELS,
    "lights": MODELS,
    "energy": MODELS | {"bsdf"},
    "ibl": MODELS | {"energy"},
    "shader": MODELS | {"energy"},
    "testkit/measure": BASE | {"sampling"},
    "testkit/subject": BASE | {"testkit/measure"},
    "testkit/verdict": BASE | {"testkit/measure", "testkit/subject"},
    "testkit/properties": BASE | {"testkit/measure", "testkit/subject", "testkit/verdict"},
    "testkit/compare": BASE | {"testkit/measure", "testkit/subject", "testkit/verdict"},
    "testkit": BASE | {"testkit/measure", "testkit/subject", "testkit/verdict", "testkit/properties", "testkit/compare"},
}
HEAVY = re.compile(r"\s*#\s*include\s*<(iostream|random|functional|glm/glm\.hpp)>")
LIGHT_ROOMS = {"core", "numeric", "ndf", "fresnel", "brdf", "bsdf", "sampling", "lights"}

found = []


def say(path, number, rule, line=""):
    if "house:" not in line:
        found.append(f"{path.relative_to(ROOT)}:{number}: {rule}" + (f": {line.strip()[:100]}" if line else ""))


def room_of(path):
    """`testkit/measure` of testkit/measure/x.hpp, `ndf` of ndf/ggx.hpp, "" of lobe.hpp."""
    parts = pathlib.PurePosixPath(path).parts[:-1]
    return "/".join(parts[:2] if parts[:1] == ("testkit",) else parts[:1])


def check_header(path):
    room = room_of(path.relative_to(HEADERS).as_posix())
    text = path.read_text(encoding="utf-8")
    if "#pragma once" not in text:
        say(path, 1, "no #pragma once")
    if room and room not in MAY_INCLUDE:
        say(path, 1, f"the room {room} is not in tests/house_rules.py")
    for number, line in enumerate(text.splitlines(), 1):
        code = line.split("//", 1)[0]
        included = re.match(r"\s*#\s*include\s*<lobe/([^>]+)>", code)
        if included and room:
            target = room_of(included.group(1))
            anyone_may = included.group(1) == "testkit/options.hpp" and room.startswith("testkit")
            if target and not anyone_may and target not in MAY_INCLUDE.get(room, set()) | {room}:
                say(path, number, f"{room} may not include {target}", line)
        if re.match(r"\s*#\s*define\b", code) and path.name != "version.hpp":
            say(path, number, "macro in a public header", line)
        if not room.startswith("testkit") and re.search(r"(?<![\w.])(1e-[2-9]|0\.0+1)f?\b", code):
            say(path, number, "an epsilon?", line)
        if re.search(r"sqrt\s*\(\s*(T\s*[({]\s*)?1(\.0?f?)?\s*[)}]?\s*-\s*(\w+(\.\w+)?)\s*\*\s*\3\s*\)", code):
            say(path, number, "cancels near 1", line)
        if re.search(r"\bstd::(pow|fma)\s*\(", code):
            say(path, number, "pow or fma in a formula", line)
        if room in LIGHT_ROOMS and HEAVY.match(code):
            say(path, number, "heavy include", line)
    if room.startswith("testkit") and text.count("\n") > 250:
        say(path, 1, f"{text.count(chr(10))} lines: a file of the kit has at most 250")


def check_source(path):
    for number, line in enumerate(path.read_text(encoding="utf-8", errors="replace").splitlines(), 1):
        if path != pathlib.Path(__file__).resolve() and re.search(r"\b(TODO|FIXME|XXX|HACK)\b|not implemented", line, re.I):
            say(path, number, "unfinished", line)
        if path.suffix in {".hpp", ".cpp", ".cu"} and len(line) > WIDTH:
            say(path, number, f"longer than {WIDTH} columns", line)


def check_tests(path):
    text = path.read_text(encoding="utf-8")
    for case in re.split(r"(?=\b(?:TEMPLATE_)?(?:LIST_)?TEST_CASE\s*\()", text)[1:]:
        if not re.search(r"REQUIRE|CHECK|static_assert|verify|expect|compare", case):
            say(path, 1, "a test case that asserts nothing", case.splitlines()[0])


for header in sorted(HEADERS.rglob("*.hpp")):
    check_header(header)
for folder in ("include", "tests", "benchmarks", "examples", "scripts"):
    for file in sorted((ROOT / folder).rglob("*")):
        if file.suffix in {".hpp", ".cpp", ".h", ".cu", ".cmake", ".sh", ".py"} and file.is_file():
            check_source(file)
for file in sorted((ROOT / "tests").rglob("*.cpp")):
    check_tests(file)
for script in ("examples/run.sh", "tests/run.sh", "benchmarks/run.sh"):
    if not (ROOT / script).is_file() or not (ROOT / script).stat().st_mode & 0o100:
        say(ROOT / script, 1, "missing, or without its run bit")
for folder in ("tests", "benchmarks", "examples", "scripts", ".ci"):
    for file in sorted((ROOT / folder).rglob("*")):
        if file.is_file() and file.suffix in {"", ".sh", ".py"} and not file.stat().st_mode & 0o100:
            if file.read_bytes()[:2] == b"#!":
                say(file, 1, "a script without its run bit")

print("\n".join(found) if found else "house rules: nothing found")
sys.exit(bool(found))
