// GLSL 4.50 and GLSL ES 3.00.
#pragma once

#include <lobe/shader/language.hpp>

namespace lobe::shader {

inline language glsl() {
    return {.name = "GLSL",
            .extension = "glsl",
            .number = "float",
            .vector_2 = "vec2",
            .vector_3 = "vec3",
            .truth = "bool",
            .suffix = "",
            .declaration = "$type $name = $value;",
            .parameter = "$type $name",
            .function = "$type $name($parameters) {\n",
            .member = "$type $name;",
            .choice = "$mask ? $a : $b",
            .returned = "    return $type($value);\n",
            .splat = "$type($value)",
            .pair = "$type($x, $y)",
            .table =
                "const $type $array[$size] = $type[]($pairs);\n\n$type $name(float i) { return $array[int(i)]; }\n",
            .structure_end = "};\n",
            .preamble = "",
            .end = "",
            .calls = {{op::atan2, "atan"}, {op::tanh, "tanh_"}},
            .missing = {op::log1p, op::expm1, op::tanh, op::erfc},
            .reserved = {"sample", "half",   "input",   "output",  "filter",    "common",    "active", "flat",
                         "smooth", "in",     "out",     "fixed",   "partition", "texture",   "superp", "patch",
                         "buffer", "shared", "precise", "reflect", "refract",   "normalize", "length", "cross",
                         "dot",    "mix",    "sign",    "step",    "exp",       "log",       "sqrt"}};
}

inline language glsl_es() {
    language es = glsl();
    es.name = "GLSL ES";
    es.extension = "es.glsl";
    es.preamble = "precision highp float;\n";
    return es;
}

}  // namespace lobe::shader
