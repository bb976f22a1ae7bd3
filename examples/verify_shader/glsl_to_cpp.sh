#!/usr/bin/env bash
# Prints a GLSL file as C++: its functions line by line, then `requested()`, one subject for each of its lines `//! verify`.
# Exit status 2, with a line that says why, if a request cannot be read.
set -euo pipefail
shopt -s extglob
file=$1

refuse() {
    echo "$file:$number: $1" >&2
    exit 2
}

# Line by line, so that the compiler's line numbers are the file's: qualifiers, v.xy as a function of GLM, 1.0 as 1.0f.
cpp() {
    sed -E '
        s/^\s*#\s*(version|extension)\b.*//
        s/^\s*precision\s.*;//
        s/^\s*layout\s*\([^)]*\)\s*//
        s/\b(lowp|mediump|highp)\s+//g
        s/^\s*(uniform|varying|in|out)\s+([^();]*;)/static \2/
        s/\b(inout|out)\s+(\w+)\s+/\2\& /g
        s/\bin\s+(\w+\s+\w)/\1/g
        s/\.([xyzw]{2,4}|[rgba]{2,4}|[stpq]{2,4})\b/.\1()/g
        :again
        s/(^|[^.[:alnum:]_])(([0-9]+\.[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)?|[0-9]+[eE][-+]?[0-9]+)($|[^.[:alnum:]_])/\1\2f\5/
        t again'
}

# GLM's v.xy() is a copy: what is written to it would be lost.
written=$(grep -nE '\.([xyzw]{2,4}|[rgba]{2,4}|[stpq]{2,4})\s*[-+*/]?=([^=]|$)' <(sed 's://.*::' "$file") | head -n 1) || true
[[ $written ]] && number=${written%%:*} && refuse "does not compile: writing to a swizzle (v.xy = ...) is not supported"

trimmed() { sed -E 's/^\s+|\s+$//g' <<<"$1"; }

# The options of a request, separated by commas.
set_options() {
    local all option value
    IFS=, read -ra all <<<"$1"
    for option in "${all[@]}"; do
        option=$(trimmed "$option") value=${option##* }
        case $option in
            "") ;;
            lossless | isotropic) echo "lobe_s.options.$option = true;" ;;
            "not reciprocal") echo "lobe_s.options.reciprocal = false;" ;;
            "not flat") echo "lobe_s.options.flat_at_normal = false;" ;;
            "not evenly spread") echo "lobe_s.options.low_discrepancy = false;" ;;
            "world space") echo "lobe_s.world_space = true;" ;;
            thorough) echo "lobe_s.options.effort = ::lobe::testkit::effort::thorough;" ;;
            "tolerance "+([0-9.])) echo "lobe_s.options.tolerance = $value;" ;;
            "points "+([0-9])) echo "lobe_s.points = $value;" ;;
            *) refuse "unknown option '$option'" ;;
        esac
    done
}

# A request is a block of C++: its first line opens it, `sample`, `pdf` and `G1` add to it.
kind='' number=0 with_sample='' with_pdf=
close() {
    [[ ! $kind ]] && return
    [[ $with_pdf && ! $with_sample ]] && refuse "a pdf without a sample, in the request above"
    echo 'lobe_all.push_back(lobe_s);'
    echo '}'
}
function_of() { # member, C++ type of the function, its parameters, expression
    echo "#line $number \"$file\""
    echo "lobe_s.$1 = []($3) -> $2 { return $2($(cpp <<<"$4")); };"
}

echo '#include "glsl.hpp"'
echo 'namespace shader {'
echo "#line 1 \"$file\""
cpp <"$file"
printf '\nstd::vector<::subject> requested() {\nstd::vector<::subject> lobe_all;\n'

request='^\s*//!\s*verify\s+(brdf|distribution|fresnel|sequence)\s+"([^"\]*)"([^:]*):\s*(.+)$'
part='^\s*//!\s*(sample|pdf|G1):\s*(.+)$'
unreadable='^\s*//!\s*verify\b'
in_request='' # other lines //! are comments, unless they follow a request: then they are misspelt
while IFS= read -r line || [[ $line ]]; do
    number=$((number + 1))
    [[ $line =~ ^[[:space:]]*//! ]] || { in_request='' && continue; }
    if [[ $line =~ $request ]]; then
        in_request=yes
        close
        kind=${BASH_REMATCH[1]} with_sample='' with_pdf=''
        expression=${BASH_REMATCH[4]}
        echo '{'
        echo '::subject lobe_s;'
        echo "lobe_s.options.name = \"$file:$number: ${BASH_REMATCH[2]}\";"
        set_options "${BASH_REMATCH[3]}"
        case $kind in
            brdf)
                echo "#line $number \"$file\""
                echo "static const auto lobe_f = [](vec3 n, vec3 v, vec3 l) { return $(cpp <<<"$expression"); };"
                echo 'lobe_s.f_cos = [](vec3 n, vec3 v, vec3 l) { return vec3(lobe_f(n, v, l)); };'
                ;;
            distribution) function_of D float 'vec3 n, vec3 m' "$expression" ;;
            fresnel) function_of F vec3 'float cosine' "$expression" ;;
            sequence) function_of point vec2 'uint i' "$expression" ;;
        esac
    elif [[ $line =~ $part ]]; then
        what=${BASH_REMATCH[1]} expression=${BASH_REMATCH[2]}
        case $kind:$what in
            brdf:sample)
                with_sample=yes
                [[ $expression == *weight* ]] || expression+='; if (pdf > 0) weight = lobe_f(n, v, l) / pdf'
                echo "#line $number \"$file\""
                echo "lobe_s.sample_light = [](vec3 n, vec3 v, vec2 u) {" \
                    "vec3 l(0, 0, 1); float pdf = 0; decltype(lobe_f(n, v, l)) weight(0); $(cpp <<<"$expression");" \
                    "return ::subject::light_sample{l, vec3(weight), pdf}; };"
                ;;
            brdf:pdf) with_pdf=yes && function_of pdf_light float 'vec3 n, vec3 v, vec3 l' "$expression" ;;
            distribution:sample) with_sample=yes && function_of sample_normal vec3 'vec3 n, vec2 u' "$expression" ;;
            distribution:pdf) with_pdf=yes && function_of pdf_normal float 'vec3 n, vec3 m' "$expression" ;;
            distribution:G1) function_of G1 float 'vec3 n, vec3 v' "$expression" ;;
            :*) refuse "'$what' before the first 'verify'" ;;
            *) refuse "a $kind has no '$what'" ;;
        esac
    elif [[ $in_request || $line =~ $unreadable ]]; then
        refuse "cannot read this request: $(trimmed "${line#*//!}")"
    fi
done <"$file"
if [[ ! $kind ]]; then
    echo "$file: asks for nothing; write a line such as  //! verify brdf \"mine\": f(n, v, l) * max(dot(n, l), 0.0)" >&2
    exit 2
fi
close
echo 'return lobe_all;'
echo '}'
echo '}'
