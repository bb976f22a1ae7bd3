#!/usr/bin/env bash
# Runs verify_shader on its three shaders, on the two wrong ones put right, and on files that it has to refuse: test_verify_shader.sh
set -uo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)/verify_shader
run=$here/run.sh
source "$here/../../scripts/setup.sh"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work"/{tmp,log} && export TMPDIR=$work/tmp # which has to be empty after each run
cd "$work" || exit 1
passed=0 failed=0

check() { # what, complaint: empty if all is well
    if [[ ! $2 ]]; then
        passed=$((passed + 1)) && echo "ok    $1"
    else
        failed=$((failed + 1)) && echo "WRONG $1:$2"
    fi
}
requests() { grep -c '^//! verify' "$here/$1.glsl"; }
tree() { find "$here" "$work" | sort; }

# ---- The three shaders: all passes, nothing passes, nothing passes.

touch log/{out,errors,junit.xml}
before=$(tree)
"$run" --junit log/junit.xml >log/out 2>log/errors
code=$?
complaint=
[[ $code == 1 ]] || complaint+=" exit code $code;"
[[ -s log/errors ]] && complaint+=" $(head -n 1 log/errors);"
expected="$(requests right) passed, 0 failed 0 passed, $(requests tutorial_mistakes) failed 0 passed, $(requests errata) failed"
[[ $(grep -E '^[0-9]+ passed, ' log/out | xargs) == "$expected" ]] || complaint+=" $(grep -E '^[0-9]+ passed, ' log/out | xargs);"
[[ $(tree) == "$before" ]] || complaint+=" left something behind;"
check "right.glsl passes; every request of tutorial_mistakes.glsl and errata.glsl fails" "$complaint"

# The same as a build server reads it: a suite a request, and as many of them failed.
counted=$(python3 - log/junit.xml <<'END'
import sys, xml.etree.ElementTree as xml
suites = xml.parse(sys.argv[1]).getroot().findall("testsuite")
assert all(int(s.get("tests")) == len(s.findall("testcase")) and int(s.get("failures")) == len(s.findall("testcase/failure")) for s in suites)
print(len(suites), sum(s.find("testcase/failure") is not None for s in suites))
END
)
wrong=$(($(requests tutorial_mistakes) + $(requests errata)))
check "junit.xml says the same" "$([[ $counted == "$(($(requests right) + wrong)) $wrong" ]] || echo " $counted")"

# A failure has to be the one that fits: the start of the request's name, and a property that fails.
report_of() { awk -v name=": $1" 'index($0, name) { on = 1 } /^$/ { on = 0 } on' log/out; }
while IFS='|' read -r name property; do
    complaint=
    grep -qE -- "^  $property.* FAILED" <(report_of "$name") || complaint=" '$property' does not fail"
    check "$name" "$complaint"
done <<'END'
diffuse without 1/pi|white furnace is at most 1
specular without 1/4|white furnace is at most 1
the cosine of the light, twice|reciprocity
the light from behind, by abs|f_cos vanishes below
specular on top of all of the diffuse|white furnace is at most 1
Fresnel of n.v|reciprocity
0.0001 in the denominator|weight \* pdf = f_cos
pow of 1 - v.h|f_cos is finite
0/0 at the horizon|f_cos is finite
GGX without the square of its denominator|integral of D cos
roughness where alpha belongs, in the masking|projected area
1 - cos^2|integral of D cos
roughness where alpha belongs, in the sampler|samples follow the pdf
the density of the normal as that of the light|mean weight = furnace
a pdf without the Jacobian|pdf\(v, sample.l\) = sample.pdf
a weight without the cosine|weight \* pdf = f_cos
samples below the horizon|sample vanishes below
i / (n - 1)|points are in \[0,1\)
x and y from one number|discrepancy is below random
S0-1:|integral of D cos
S0-2:|projected area
S0-3:|F is flat at normal incidence
S0-4:|white furnace is at most 1
S0-5:|mean weight = furnace
S0-6:|integral of the pdf = successes
S0-7:|white furnace is at most 1
S0-8:|weight \* pdf = f_cos
S0-9:|white furnace is at most 1
S0-13:|pdf = D cos
S1-1:|f_cos is not negative
S1-2:|white furnace is 1
S1-3:|reciprocity
S1-5:|white furnace is 1
S1-10:|white furnace is 1
S2-1:|projected area
S2-3:|F at grazing is at least F at normal
S2-4:|reciprocity
S2-10:|white furnace is at most 1
S3-2: 0.001 in|weight \* pdf = f_cos
S3-2: 0.001 under|F is at most 1
S3-4:|weight \* pdf = f_cos
S3-6:|projected area
S3-10:|points are in \[0,1\)
S3-13:|weight \* pdf = f_cos
S3-14:|normals follow the pdf
S3-15:|points are in \[0,1\)
S4-1:|D is finite
S4-4:|projected area
S4-5:|D is finite
S4-6:|integral of D cos
S4-7:|integral of D cos
S4-9:|integral of D cos
S4-10:|integral of D cos
S4-15:|D is finite
END

# ---- Each x of a request replaced by x_right, which stands beside it: all passes.

for shader in tutorial_mistakes errata; do
    names=$(grep -oE '\b\w+_right\(' "$here/$shader.glsl" | sed 's/_right($//' | sort -u | paste -sd'|')
    sed -E "/^\/\/!/s/\b($names)\(/\1_right(/g" "$here/$shader.glsl" >"${shader}_right.glsl"
done

# ---- What is common in GLSL and strange to C++ passes, too: qualifiers, swizzles, literals, a uniform, main(), carriage returns.

cat >dialect.glsl <<'END'
#version 300 es
//! A comment for Doxygen.
precision highp float;
uniform float roughness;
layout(location = 0) out vec4 color;
in vec3 world_normal;
#define PI 3.14159265
#define saturate(x) clamp(x, 0.0, 1.0)
void swap(inout float a, inout float b) { float t = a; a = b; b = t; }
float lobe(in highp vec3 v, const in vec3 l) { return saturate(l.z) * step(1e-9, v.z) / PI; }
vec3 diffuse(vec3 v, vec3 l) {
    float sum = 0., w[2];
    for (int i = 0; i < 4; ++i) sum += .25 * lobe(v, l);
    w[0] = 2.0; w[1] = 1.;
    swap(w[0], w[1]);
    vec4 c = vec4(vec3(sum).rgb, 1.E0);
    return c.zyx * w[0] * (roughness == 0.3 ? 1.0 : 1.0e3);
}
float pdf(vec3 v, vec3 l) { return max(l.z, 0.0) / PI; }
vec3 square_to_hemisphere(vec2 u) { return vec3(sqrt(u.x) * cos(2.0 * PI * u.y), sqrt(u.x) * sin(2.0 * PI * u.y), sqrt(1.0 - u.x)); }
//! verify brdf "mine, with a uniform", lossless, isotropic: (roughness = 0.3, diffuse(v, l))
//!     sample: l = square_to_hemisphere(u), pdf = l.z / PI
//!     pdf: pdf(v, l)
void main() { color = vec4(world_normal, 1.0); }
END
sed 's/$/\r/' dialect.glsl >carriage_returns.glsl

# Blocks, textures and main() beside what is verified; names of C++, functions of GLM; arrays, swizzles, integers among floats.
cat >vulkan.glsl <<'END'
#version 450
layout(set = 1, binding = 0) uniform sampler2D base_color;
layout(std140, set = 0, binding = 0) uniform Scene
{
    layout(row_major) mat4 view;
    vec3 lights[4];
};
layout(push_constant) uniform Material { layout(offset = 16) float roughness; } material;
layout(std430, binding = 3) readonly buffer Points { vec2 points[]; };
layout(constant_id = 0) const float half_ = 0.5;
layout(location = 0) in Vertex { vec3 normal; flat int id; } vertex;
layout(location = 0) out vec4 color;
#if __VERSION__ != 450 || defined(GL_ES) || __FILE__ != 0 || __LINE__ != 13
#error
#endif
#define lambert(v, \
                l) (new(l, half_) / \
                3.14159\
265)
struct S { float w[2]; vec3 a; };
const S table[2] = S[](S(float[](0.25, 0.5), vec3(1)), S(float[](0.5, 0.25), vec3(0, 1, 2)));
const float grid[2][2] = float[2][2](float[](1.0, 2.0), float[](3.0, 4.0));
float round(float x) { return 2 * x; }
float pow(float x, float y) { return x; }
double sum(float a[2]) {
    double s = 0.0lf;
    for (int i = 0; i < a.length(); ++i) s += a[i];
    return s;
}
float new(vec3 delete, float NULL) {
    vec3 assert = delete;
    assert.xy = assert.yx;
    assert.zx *= vec2(round(NULL), 1);
    bvec3 not_one = not(equal(assert, vec3(2)));
    S s = table[int(not_one.x)];
    s.a = inverse(mat3(2)) * (s.a + grid[1][1]);
    return max(assert.z, 0) * float(sum(s.w)) / 0.75 * pow(NULL / 0.5, 7.0);
}
float lit(vec3 v, vec3 l) { return lights[1].y * lambert(v, l) * material.roughness; }
//! verify brdf "blocks", isotropic, lossless: (material.roughness = 0.3, lights[1] = vec3(1), lit(v, l) / 0.3)
vec4 shade() {
    if (points[0].x > 0) discard;
    return texture(base_color, gl_FragCoord.xy) + dFdx(vertex.normal.x);
}
void main() { color = shade() * view; }
END

# Old GLSL, in which `sample` is a name.
cat >old.glsl <<'END'
#version 120
#extension GL_ARB_shader_texture_lod : enable
attribute vec3 position;
varying vec2 at;
uniform sampler2D map;
vec3 sample(vec2 u) { return vec3(sqrt(u.x) * cos(6.28318531 * u.y), sqrt(u.x) * sin(6.28318531 * u.y), sqrt(1.0 - u.x)); }
void sample_both(vec2 u, out vec3 l, out float weight, out float pdf) { l = sample(u); weight = 1.0; pdf = l.z / 3.14159265; }
//! verify brdf "weight by division", lossless: max(l.z, 0.0) / 3.14159265
//!     sample: l = sample(u), pdf = l.z / 3.14159265
//! verify brdf "weight, a float", lossless: max(l.z, 0.0) / 3.14159265
//!     sample: sample_both(u, l, weight, pdf)
void main() { gl_FragColor = texture2D(map, at); }
END

# Names and encodings.
schlick='float F(float c) { return 0.04 + 0.96 * pow(1.0 - c, 5.0); } // café
//! verify fresnel "Schlick": F(cosine)
//- verify fresnel "switched off": 2.0
// A fresnel "approximation": prose.

//! A comment, very fast, to verify nothing.'
mkdir 'a folder'
quoted='a folder/a "quote", $HOME; a \a?.glsl'
printf '%s\n' "$schlick" >"$quoted"
printf '\xef\xbb\xbf#version 450\n%s\n' "$schlick" >-x.glsl
{ printf '\xff\xfe' && iconv -f UTF-8 -t UTF-16LE <<<"$schlick"; } >utf16.glsl
{ printf '\xfe\xff' && iconv -f UTF-8 -t UTF-16BE <<<"$schlick"; } >utf16_be.glsl
iconv -f UTF-8 -t LATIN1 <<<"$schlick" >latin1.glsl

files=({tutorial_mistakes_right,errata_right,dialect,carriage_returns,vulkan,old,-x,utf16,utf16_be,latin1}.glsl "$quoted")
"$run" --all "${files[@]}" >log/out 2>log/errors
code=$?
for file in "${files[@]}"; do
    complaint=
    grep -F -- "$file:" log/out | grep -q ': passed' || complaint+=" nothing passes;"
    complaint+=$(grep -hF -- "$file:" log/out log/errors | grep -v ': passed' | head -n 3)
    check "$file passes" "$complaint"
done
check "all of them together" "$([[ $code == 0 ]] || echo " exit code $code")"
check "what is switched off is not verified" "$(grep -o 'switched off' log/out)"
check "--all prints every property" "$(grep -q 'white furnace is at most 1  *ok' log/out || echo ' no furnace that passed')"

complaint=
while read -r _ id _; do
    grep -qE "\b$id\b" "$here/errata.glsl" || complaint+=" $id"
done < <(grep -E '^\| S[0-9]-[0-9]+ ' "$here/../../docs/errata.md")
check "errata.glsl names every erratum" "$complaint"

# ---- Requests are found wherever a comment can stand: each but the first of these fails.

{
    echo 'float F(float c) { return 0.04 + 0.96 * pow(1.0 - c, 5.0); }'
    echo '//! verify fresnel "Schlick": F(cosine)'
    echo 'float G(float c) { return 2.0 * F(c); } //! verify fresnel "behind code": G(cosine)'
    echo '    //! verify fresnel "indented": G(cosine)'
    printf '\t//!\tverify\tfresnel\t"tabs"\t:\tG(cosine)\n'
    echo '//!verify fresnel"no blanks":G(cosine)'
    echo '/* a // b */ //! verify fresnel "behind a comment": G(cosine)'
    echo '//! verify fresnel "on two lines": \'
    echo '    G(cosine)'
} >places.glsl
tr '\n' '\r' <places.glsl >places_cr.glsl
"$run" places.glsl places_cr.glsl >log/out 2>log/errors
code=$?
complaint=
[[ $code == 1 ]] || complaint+=" exit code $code;"
found=$(grep -E '^[0-9]+ passed, ' log/out | xargs)
[[ $found == "1 passed, 6 failed 1 passed, 6 failed" ]] || complaint+=" $found $(head -n 1 log/errors)"
check "requests behind code, indented, with tabs, without blanks, on two lines" "$complaint"

# ---- Files that are refused: exit code 2, one line that names the file and the line, nothing left behind.

refused() { # file, what the line has to hold
    local complaint='' code before
    before=$(tree)
    "$run" "$1" >log/out 2>log/errors
    code=$?
    [[ $code == 2 ]] || complaint+=" exit code $code;"
    [[ ! -s log/out && $(wc -l <log/errors) == 1 ]] || complaint+=" not one line;"
    grep -qF -- "$1" log/errors && grep -qE -- "$2" log/errors || complaint+=" does not say $1 and $2;"
    [[ $(tree) == "$before" ]] || complaint+=" left something behind;"
    check "$(head -n 1 log/errors)" "$complaint"
}
f='float f(float x) { return x * x; }'
request='//! verify fresnel "mine": f(cosine)'

refused missing.glsl "no such file"
mkdir folder.glsl && refused folder.glsl "is a folder"
: >empty.glsl && refused empty.glsl "asks for nothing"
printf '%s\n' "$f" >nothing.glsl && refused nothing.glsl "asks for nothing"
printf '%s\n' '#version 450' 'float f(float x) {' '    return y;' '}' "$request" >broken.glsl && refused broken.glsl "broken.glsl:3: does not compile.*'y'"
printf '%s\n' 'float f(float x) { return x }' "$request" >semicolon.glsl && refused semicolon.glsl "semicolon.glsl:1: does not compile"
printf '%s\n' "$f" "//! verify fresnel \"mine\": g(cosine)" >unknown.glsl && refused unknown.glsl "unknown.glsl:2: does not compile.*'g'"
printf '%s\n' 'float f(float x);' "$request" >undefined.glsl && refused undefined.glsl "does not link.*f\(f1"
printf '%s\n' "$f" '//! verify fresnel mine: f(cosine)' >unquoted.glsl && refused unquoted.glsl ":2: cannot read this request"
printf '%s\n' "$f" "$request" '//! smple: 1.0' >misspelt.glsl && refused misspelt.glsl ":3: cannot read this request"
printf '%s\n' "$f" '//! verify fresnel "mine", shiny: f(cosine)' >option.glsl && refused option.glsl ":2: unknown option 'shiny'"
printf '%s\n' "$f" "$request" '//!     sample: f(u.x)' >part.glsl && refused part.glsl ":3: a fresnel has no 'sample'"
printf '%s\n' "$f" '//! pdf: f(v.x)' >orphan.glsl && refused orphan.glsl ":2: 'pdf' before the first 'verify'"

# A request that would be passed over, beside one that is read.
while IFS='|' read -r name line says; do
    printf '%s\n' "$f" "$request" '' "${line//@/verify fresnel \"mine\": f(cosine)}" >"$name.glsl"
    refused "$name.glsl" ":4: $says"
done <<'END'
block|/* //! @ */|a request that would not be read
doxygen|/*! @ */|a request that would not be read
no_mark|// @|a request that would not be read
three|/// @|a request that would not be read
disabled|// //! @|a request that would not be read
spaced|// ! @|a request that would not be read
two_marks|//!! @|cannot read
two|//! @ //! @|a line holds one request
no_verb|//! fresnel "mine": f(cosine)|cannot read
other_verb|//! check fresnel "mine": f(cosine)|cannot read
verb|//! verfy fresnel "mine": f(cosine)|cannot read
case|//! Verify fresnel "mine": f(cosine)|cannot (read|verify)
kind|//! verify btdf "mine": f(cosine)|cannot verify a 'btdf'
no_name|//! verify fresnel: f(cosine)|cannot read
no_expression|//! verify fresnel "mine":|cannot read
part_name|//! smaple: f(u.x)|cannot read
part_case|//! PDF: f(u.x)|cannot read
not_its_option|//! verify fresnel "mine", points 5: f(cosine)|a fresnel has no option
END

# What a function cannot do alone, and what is not GLSL.
while IFS='|' read -r name line says; do
    printf '%s\n' '#version 450' "$line" '//! verify brdf "mine": f(v, l)' >"$name.glsl"
    refused "$name.glsl" ":2: $says"
done <<'END'
texture|uniform sampler2D t; float f(vec3 v, vec3 l) { return texture(t, v.xy).x; }|a texture .t. is not supported
image|layout(r32f) uniform image2D t; float f(vec3 v, vec3 l) { return imageLoad(t, ivec2(v.xy)).x; }|a texture .t. is not supported
buffer|buffer B { float x[]; } b; float f(vec3 v, vec3 l) { return b.x[0]; }|a buffer .b. is not supported
builtin|float f(vec3 v, vec3 l) { return gl_FragCoord.x; }|a gl_ input .gl_FragCoord. is not supported
discard|float f(vec3 v, vec3 l) { if (l.z < 0) discard; return l.z; }|discard is not supported
derivative|float f(vec3 v, vec3 l) { return dFdx(l.z); }|dFdx, dFdy or fwidth is not supported
include|#include "f.glsl"|#include is not supported
reserved|float template(float x) { return x; }|does not compile.*'template'
cast|float f(vec3 v, vec3 l) { return (float)l.z; }|does not compile
cpp|float f(vec3 v, vec3 l) { return std::max(l.z, 0.0); }|does not compile
bool|float f(vec3 v, vec3 l) { return (l.z > 0.0) * l.z; }|does not compile
not_ascii|float é = 1.0;|does not compile
extension|#extension GL_FOO_bar : require|does not compile.*GL_FOO_bar
END
printf '%s\n' '#version 450' 'float f(vec3 v, vec3 l) { return f(v, l); }' '//! verify brdf "mine": f(v, l)' >recursion.glsl
refused recursion.glsl "does not link: Recursion"
printf '%s\0' "$f" "$request" >zeros.glsl && refused zeros.glsl "is not a text"

# ---- The shaders are GLSL of the version that they say.

for shader in "$here"/{right,tutorial_mistakes,errata}.glsl; do
    { cat "$shader" && echo 'void main() {}'; } >wrapped.frag
    check "glslang accepts $(basename "$shader")" "$(glslangValidator wrapped.frag >log/out || grep -m 1 ERROR log/out)"
done
# A folder, as a build server verifies it: its shaders that ask for something, wherever they are.
folder=$here/../ci/verify_folder.sh
mkdir -p shaders/deep
echo 'void main() {}' >shaders/asks_for_nothing.frag
"$folder" shaders log/junit.xml >log/out 2>&1
check "a folder that asks for nothing is refused" "$([[ $? == 2 ]] || echo " $(head -n 1 log/out)")"
printf '//! verify fresnel "Schlick": F(\n' >'shaders/deep/an error.frag'
"$folder" shaders log/junit.xml >log/out 2>&1
check "a folder's shaders are found, and read" "$([[ $? == 2 ]] && grep -q '^shaders/deep/an error.frag:1: ' log/out || echo " $(head -n 1 log/out)")"

cp dialect.glsl dialect.frag
check "glslang accepts the dialect" "$(glslangValidator dialect.frag >log/out || grep -m 1 ERROR log/out)"

echo "$passed passed, $failed failed"
[[ $failed == 0 ]]
