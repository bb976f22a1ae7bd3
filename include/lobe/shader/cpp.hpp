// C++, from C++11 on, and CUDA: no include of lobe or of GLM.
#pragma once

#include <lobe/shader/language.hpp>

namespace lobe::shader {

namespace detail {

/// The vectors that C++ lacks; `$call` before each function.
inline std::string cpp_vectors(const std::string& call) {
    std::string text = "\n#ifndef LOBE_SHADING_VECTORS\n#" + std::string("define LOBE_SHADING_VECTORS") + R"(
namespace shading {

struct vec2 {
    float x, y;
    $call vec2(float a, float b) : x(a), y(b) {}
};
struct vec3 {
    float x, y, z;
    $call vec3(float a, float b, float c) : x(a), y(b), z(c) {}
    $call explicit vec3(float a) : x(a), y(a), z(a) {}
};
$call inline vec3 operator-(vec3 a) { return vec3(-a.x, -a.y, -a.z); }
)";
    for (const std::string sign : {"+", "-", "*", "/"})
        text += "$call inline vec3 operator" + sign + "(vec3 a, vec3 b) { return vec3(a.x " + sign + " b.x, a.y " +
                sign + " b.y, a.z " + sign + " b.z); }\n$call inline vec3 operator" + sign +
                "(vec3 a, float b) { return vec3(a.x " + sign + " b, a.y " + sign + " b, a.z " + sign +
                " b); }\n$call inline vec3 operator" + sign + "(float a, vec3 b) { return vec3(a " + sign + " b.x, a " +
                sign + " b.y, a " + sign + " b.z); }\n";
    text += "$call inline float dot(vec3 a, vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }\n"
            "$call inline float max(float a, float b) { return a < b ? b : a; }\n"
            "$call inline float min(float a, float b) { return b < a ? b : a; }\n";
    for (const std::string f :
         {"abs", "sqrt", "exp", "exp2", "expm1", "log", "log2", "log1p", "sin", "cos", "tanh", "acos", "erfc", "floor"})
        text += "using std::" + f + ";\n$call inline vec3 " + f + "(vec3 a) { return vec3(" + f + "(a.x), " + f +
                "(a.y), " + f + "(a.z)); }\n";
    for (const std::string f : {"max", "min", "pow", "atan2"})
        text += (f.size() == 3 && f != "pow" ? "" : "using std::" + f + ";\n") + "$call inline vec3 " + f +
                "(vec3 a, vec3 b) { return vec3(" + f + "(a.x, b.x), " + f + "(a.y, b.y), " + f + "(a.z, b.z)); }\n";
    text += "\n}  // namespace shading\n#endif\n\nnamespace shading {\n";
    return filled(text, {{"call", call}});
}

}  // namespace detail

inline language cpp() {
    return {.name = "C++",
            .extension = "hh",
            .number = "float",
            .vector_2 = "vec2",
            .vector_3 = "vec3",
            .truth = "bool",
            .suffix = "f",
            .declaration = "const $type $name = $value;",
            .parameter = "$type $name",
            .function = "inline $type $name($parameters) {\n",
            .member = "$type $name;",
            .choice = "$mask ? $a : $b",
            .returned = "    return {$value};\n",
            .splat = "$type($value)",
            .pair = "{$x, $y}",
            .table = "inline $type $name(float i) {\n    static constexpr float values[$size][2] = {$pairs};\n"
                     "    const float* at = values[static_cast<int>(i)];\n    return $type(at[0], at[1]);\n}\n",
            .structure_end = "};\n",
            .preamble = "#pragma once\n\n#include <cmath>\n" + detail::cpp_vectors(""),
            .end = "\n}  // namespace shading\n",
            .calls = {},
            .missing = {},
            .reserved = {"template", "class", "new",     "this",   "signed",   "and",   "or",      "not",
                         "int",      "auto",  "default", "switch", "dot",      "exp",   "log",     "sqrt",
                         "abs",      "max",   "min",     "pow",    "register", "union", "private", "public"}};
}

inline language cuda() {
    language c = cpp();
    c.name = "CUDA";
    c.extension = "cuh";
    c.function = "__host__ __device__ inline $type $name($parameters) {\n";
    c.table = "__host__ __device__ " + c.table;
    c.preamble = "#pragma once\n\n#include <cmath>\n" + detail::cpp_vectors("__host__ __device__");
    return c;
}

}  // namespace lobe::shader
