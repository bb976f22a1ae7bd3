// HLSL from shader model 5.0 on, which is Slang as well.
#pragma once

#include <lobe/shader/language.hpp>

namespace lobe::shader {

inline language hlsl() {
    return {.name = "HLSL",
            .extension = "hlsl",
            .number = "float",
            .vector_2 = "float2",
            .vector_3 = "float3",
            .truth = "bool",
            .suffix = "",
            .declaration = "const $type $name = $value;",
            .parameter = "$type $name",
            .function = "$type $name($parameters) {\n",
            .member = "$type $name;",
            .choice = "$mask ? $a : $b",
            .returned = "    const $type returned = {$value};\n    return returned;\n",
            .splat = "((float3)($value))",
            .pair = "$type($x, $y)",
            .table =
                "static const $type $array[$size] = {$pairs};\n\n$type $name(float i) { return $array[int(i)]; }\n",
            .structure_end = "};\n",
            .preamble = "",
            .end = "",
            .calls = {{op::tanh, "tanh_"}},
            .missing = {op::log1p, op::expm1, op::tanh, op::erfc},
            .reserved = {"sample",  "half",      "in",      "out",      "point",   "line",    "triangle",  "linear",
                         "texture", "matrix",    "vector",  "returned", "reflect", "refract", "normalize", "length",
                         "cross",   "dot",       "lerp",    "sign",     "step",    "exp",     "log",       "sqrt",
                         "pass",    "technique", "precise", "shared",   "export",  "noise",   "snorm",     "unorm"}};
}

}  // namespace lobe::shader
