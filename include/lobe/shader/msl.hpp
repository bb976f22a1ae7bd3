// Metal's shading language.
#pragma once

#include <lobe/shader/language.hpp>

namespace lobe::shader {

inline language msl() {
    return {.name = "MSL",
            .extension = "metal",
            .number = "float",
            .vector_2 = "float2",
            .vector_3 = "float3",
            .truth = "bool",
            .suffix = "f",
            .declaration = "const $type $name = $value;",
            .parameter = "$type $name",
            .function = "inline $type $name($parameters) {\n",
            .member = "$type $name;",
            .choice = "$mask ? $a : $b",
            .returned = "    return $type{$value};\n",
            .splat = "$type($value)",
            .pair = "$type($x, $y)",
            .table =
                "constant $type $array[$size] = {$pairs};\n\ninline $type $name(float i) { return $array[int(i)]; }\n",
            .structure_end = "};\n",
            .preamble = "#include <metal_stdlib>\nusing namespace metal;\n",
            .end = "",
            .calls = {{op::tanh, "tanh_"}},
            .missing = {op::log1p, op::expm1, op::tanh, op::erfc},
            .reserved = {"half",     "sample", "kernel",  "vertex",  "fragment",  "device", "constant", "thread",
                         "template", "class",  "new",     "this",    "signed",    "and",    "or",       "not",
                         "int",      "auto",   "reflect", "refract", "normalize", "length", "cross",    "dot",
                         "mix",      "sign",   "step",    "exp",     "log",       "sqrt"}};
}

}  // namespace lobe::shader
