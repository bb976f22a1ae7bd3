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

touch log/out log/errors
before=$(tree)
"$run" >log/out 2>log/errors
code=$?
complaint=
[[ $code == 1 ]] || complaint+=" exit code $code;"
[[ -s log/errors ]] && complaint+=" $(head -n 1 log/errors);"
expected="$(requests right) passed, 0 failed 0 passed, $(requests tutorial_mistakes) failed 0 passed, $(requests errata) failed"
[[ $(grep -E '^[0-9]+ passed, ' log/out | xargs) == "$expected" ]] || complaint+=" $(grep -E '^[0-9]+ passed, ' log/out | xargs);"
[[ $(tree) == "$before" ]] || complaint+=" left something behind;"
check "right.glsl passes; every request of tutorial_mistakes.glsl and errata.glsl fails" "$complaint"

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

files=({tutorial_mistakes_right,errata_right,dialect,carriage_returns}.glsl)
"$run" --all "${files[@]}" >log/out 2>log/errors
code=$?
for file in "${files[@]}"; do
    complaint=
    grep -q "^$file:.*: passed" log/out || complaint+=" nothing passes;"
    complaint+=$(grep -hE "^$file:.*(FAILED|compile|link)" log/out log/errors | head -n 3)
    check "$file passes" "$complaint"
done
check "all of them together" "$([[ $code == 0 ]] || echo " exit code $code")"
check "--all prints every property" "$(grep -q 'white furnace is at most 1  *ok' log/out || echo ' no furnace that passed')"

complaint=
while read -r _ id _; do
    grep -qE "\b$id\b" "$here/errata.glsl" || complaint+=" $id"
done < <(grep -E '^\| S[0-9]-[0-9]+ ' "$here/../../docs/errata.md")
check "errata.glsl names every erratum" "$complaint"

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
mkdir folder.glsl && refused folder.glsl "no such file"
printf '%s\n' "$f" >nothing.glsl && refused nothing.glsl "asks for nothing"
printf '%s\n' '#version 450' 'float f(float x) {' '    return y;' '}' "$request" >broken.glsl && refused broken.glsl "broken.glsl:3: does not compile.*'y'"
printf '%s\n' 'float f(float x) { return x }' "$request" >semicolon.glsl && refused semicolon.glsl "semicolon.glsl:1: does not compile"
printf '%s\n' "$f" "//! verify fresnel \"mine\": g(cosine)" >unknown.glsl && refused unknown.glsl "unknown.glsl:2: does not compile.*'g'"
printf '%s\n' 'float f(float x);' "$request" >undefined.glsl && refused undefined.glsl "does not link.*f\(float\)"
printf '%s\n' "$f" '//! verify fresnel mine: f(cosine)' >unquoted.glsl && refused unquoted.glsl ":2: cannot read this request"
printf '%s\n' "$f" "$request" '//! smple: 1.0' >misspelt.glsl && refused misspelt.glsl ":3: cannot read this request"
printf '%s\n' "$f" '//! verify fresnel "mine", shiny: f(cosine)' >option.glsl && refused option.glsl ":2: unknown option 'shiny'"
printf '%s\n' "$f" "$request" '//!     sample: f(u.x)' >part.glsl && refused part.glsl ":3: a fresnel has no 'sample'"
printf '%s\n' "$f" '//! pdf: f(v.x)' >orphan.glsl && refused orphan.glsl ":2: 'pdf' before the first 'verify'"
printf '%s\n' 'vec3 g(vec3 a) { a.xy = a.yx; return a; }' "$f" "$request" >written.glsl && refused written.glsl ":1: .*writing to a swizzle"

# ---- The shaders are GLSL.

(need glslang-tools) >/dev/null 2>&1
if command -v glslangValidator >/dev/null; then
    for shader in "$here"/{right,tutorial_mistakes,errata}.glsl; do
        { cat "$shader" && echo 'void main() {}'; } >wrapped.frag
        check "glslang accepts $(basename "$shader")" "$(glslangValidator wrapped.frag >log/out || grep -m 1 ERROR log/out)"
    done
    cp dialect.glsl dialect.frag
    check "glslang accepts the dialect" "$(glslangValidator dialect.frag >log/out || grep -m 1 ERROR log/out)"
else
    echo "glslangValidator is not installed: whether the shaders are GLSL was not looked at"
fi

echo "$passed passed, $failed failed"
[[ $failed == 0 ]]
