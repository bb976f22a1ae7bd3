// WGSL, of WebGPU.
#pragma once

#include <lobe/shader/language.hpp>

namespace lobe::shader {

inline language wgsl() {
    return {.name = "WGSL",
            .extension = "wgsl",
            .number = "f32",
            .vector_2 = "vec2f",
            .vector_3 = "vec3f",
            .truth = "bool",
            .suffix = "",
            .declaration = "let $name = $value;",
            .parameter = "$name: $type",
            .function = "fn $name($parameters) -> $type {\n",
            .member = "$name: $type,",
            .choice = "select($b, $a, $mask)",
            .returned = "    return $type($value);\n",
            .splat = "$type($value)",
            .pair = "$type($x, $y)",
            .table =
                "const $array = array<$type, $size>($pairs);\n\nfn $name(i: f32) -> $type { return $array[i32(i)]; }\n",
            .structure_end = "}\n",
            .preamble = "",
            .end = "",
            .calls = {{op::tanh, "tanh_"}},
            .missing = {op::log1p, op::expm1, op::tanh, op::erfc},
            .reserved = {"half",    "sample",  "filter",    "common",   "active", "smooth",  "target",
                         "mod",     "ref",     "self",      "std",      "type",   "unit",    "var",
                         "let",     "fn",      "select",    "override", "enable", "private", "public",
                         "reflect", "refract", "normalize", "length",   "cross",  "dot",     "mix",
                         "sign",    "step",    "exp",       "log",      "sqrt"}};
}

}  // namespace lobe::shader
