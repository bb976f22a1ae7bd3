// Prints the functions of functions.inc: write LANGUAGE FILE. Or each with a kernel that calls it for an array:
// write kernels GLSL|HLSL FOLDER. Or what browser.mjs runs: write browser FOLDER
#include "derivatives.hpp"
#include "inputs.hpp"

#include <lobe/shader.hpp>

#include <charconv>
#include <cmath>
#include <fstream>
#include <iostream>
#include <string_view>

using small = std::decay_t<decltype(shader_tests::small_table())>;
template <>
struct shader_tests::terms_of<lobe::shader::real> : lobe::shader::dfg<small> {
    terms_of() : dfg(printed_once()) {}
    static const dfg& printed_once() {
        static const dfg once("table", shader_tests::small_table());
        return once;
    }
};

namespace {

using lobe::shader::real;
namespace shader = lobe::shader;

template <class F>
auto recorded(const char* name, const F& f) {
    return shader::function(name, {"v", "l", "u", "width", "x"},
                            [&](shader::vec3 v, shader::vec3 l, shader::vec2 u, real width, real x) {
                                return f(shader_tests::input<real>{v, l, u, width, x});
                            });
}

/// found[begin k] = the kth number of the result r, a line each.
std::string stores(const shader::body& function, const std::string& begin) {
    std::string text;
    std::uint32_t component = 0;
    shader::detail::for_each_part(
        function.result, "r", component, [&](const shader::type& t, const std::string& name, std::uint32_t first) {
            const bool number = t.kind == shader::type::number;
            if (!number && t.kind != shader::type::vector_2 && t.kind != shader::type::vector_3) return;
            const char* parts[] = {".x", ".y", ".z"};
            for (std::uint32_t i = 0; i < shader::components(t); ++i)
                text +=
                    "    found[" + begin + std::to_string(first + i) + "] = " + name + (number ? "" : parts[i]) + ";\n";
        });
    return text;
}

/// 10 numbers in, 7 numbers out, an invocation each.
std::string kernel(const shader::body& function, bool hlsl) {
    std::string text =
        hlsl
            ? "\n[[vk::binding(0)]] RWStructuredBuffer<float> given;\n[[vk::binding(1)]] RWStructuredBuffer<float> "
              "found;\n[numthreads(64, 1, 1)] void main(uint3 id : SV_DispatchThreadID) {\n    const uint i = 10 * "
              "id.x, "
              "o = 7 * id.x;\n"
            : "\nlayout(local_size_x = 64) in;\nlayout(std430, binding = 0) buffer inputs { float given[]; };\n"
              "layout(std430, binding = 1) buffer outputs { float found[]; };\nvoid main() {\n    const uint i = 10u * "
              "gl_GlobalInvocationID.x, o = 7u * gl_GlobalInvocationID.x;\n";
    const std::string vector = hlsl ? "float" : "vec";
    text += "    " + shader::detail::in(hlsl ? shader::hlsl() : shader::glsl(), function.result) +
            " r = " + function.name + "(" + vector + "3(given[i], given[i + 1], given[i + 2]), " + vector +
            "3(given[i + 3], given[i + 4], given[i + 5]), " + vector +
            "2(given[i + 6], given[i + 7]), given[i + 8], given[i + 9]);\n";
    return text + stores(function, "o + ") + "}\n";
}

std::string wgsl_kernel(const shader::body& function) {
    return "\n@group(0) @binding(0) var<storage, read> given: array<f32>;\n@group(0) @binding(1) var<storage, "
           "read_write> found: array<f32>;\n@compute @workgroup_size(64) fn main(@builtin(global_invocation_id) id: "
           "vec3u) {\n    let i = 10u * id.x;\n    let o = 7u * id.x;\n    let r = " +
           function.name +
           "(vec3f(given[i], given[i + 1], given[i + 2]), vec3f(given[i + 3], given[i + 4], given[i + 5]), "
           "vec2f(given[i + 6], given[i + 7]), given[i + 8], given[i + 9]);\n" +
           stores(function, "o + ") + "}\n";
}

/// A vertex shader, for WebGL 2 has no other way to many numbers of full precision: transform feedback captures what
/// it finds, though not an array.
std::string es_kernel(const shader::body& function) {
    return "\nlayout(location = 0) in vec3 given_v;\nlayout(location = 1) in vec3 given_l;\nlayout(location = 2) in "
           "vec2 given_u;\nlayout(location = 3) in vec2 given_width_x;\nflat out vec4 found_0123;\nflat out vec3 "
           "found_456;\nvoid main() {\n    gl_Position = vec4(0.0);\n    float found[7];\n"
           "    for (int k = 0; k < 7; ++k) found[k] = 0.0;\n    " +
           shader::detail::in(shader::glsl_es(), function.result) + " r = " + function.name +
           "(given_v, given_l, given_u, given_width_x.x, given_width_x.y);\n" + stores(function, "") +
           "    found_0123 = vec4(found[0], found[1], found[2], found[3]);\n"
           "    found_456 = vec3(found[4], found[5], found[6]);\n}\n";
}

std::string json(double x) {
    char text[40];
    return std::isfinite(x) && std::abs(x) < 3e38 ? std::string(text, std::to_chars(text, text + sizeof text, x).ptr)
                                                  : "null";
}
std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) result += c == '\n' ? std::string("\\n") : std::string(1, c);
    return result + "\"";
}

struct doubles {
    std::vector<double> at;
    void add(double x) { at.push_back(x); }
};

/// For browser.mjs: inputs; of each function its WGSL and GLSL ES with kernels, lobe's results in double and in float.
void write_cases(std::ostream& to) {
    shader_tests::random_inputs random;
    std::vector<shader_tests::input<float>> inputs;
    to << "{\"inputs\":[";
    for (int i = 0; i < 256; ++i) {
        const auto& in = inputs.emplace_back(random());
        for (const float x : {in.v.x, in.v.y, in.v.z, in.l.x, in.l.y, in.l.z, in.u.x, in.u.y, in.width})
            to << json(double(x)) << ',';
        to << json(double(in.x)) << (i < 255 ? "," : "");
    }
    to << "],\"functions\":[";
    bool first = true;
    shader_tests::for_each_function([&](const char* name, const auto& f) {
        const auto one = recorded(name, f);
        doubles exact, cpu;
        for (const auto& in : inputs) {
            const shader_tests::input<double> wide{lobe::vec3<double>(in.v), lobe::vec3<double>(in.l),
                                                   lobe::vec2<double>(in.u), in.width, in.x};
            shader_tests::collect(f(wide), exact);
            shader_tests::collect(f(in), cpu);
        }
        shader::file file;
        file.add(one);
        to << (first ? "" : ",\n") << "{\"name\":\"" << name << "\",\"count\":" << exact.at.size() / inputs.size()
           << ",\"wgsl\":" << quoted(file.print(shader::wgsl()) + wgsl_kernel(*one.recording()))
           << ",\"es\":" << quoted("#version 300 es\n" + file.print(shader::glsl_es()) + es_kernel(*one.recording()));
        for (const auto& [what, values] : {std::pair("exact", &exact.at), std::pair("cpu", &cpu.at)}) {
            to << ",\"" << what << "\":[";
            for (std::size_t i = 0; i < values->size(); ++i) to << (i ? "," : "") << json((*values)[i]);
            to << ']';
        }
        to << '}';
        first = false;
    });
    to << "]}\n";
}

}  // namespace

int main(int, char** arguments) {
    const std::string_view what = arguments[1];
    if (what == "browser") {
        std::ofstream to(std::string(arguments[2]) + "/cases.json");
        write_cases(to);
        return !to.flush();
    }
    if (what == "kernels") {
        const bool hlsl = std::string_view(arguments[2]) == "HLSL";
        bool written = true;
        shader_tests::for_each_function([&](const char* name, const auto& f) {
            const auto one = recorded(name, f);
            shader::file file;
            file.add(one);
            std::ofstream to(std::string(arguments[3]) + "/" + name + (hlsl ? ".hlsl" : ".comp"));
            to << (hlsl ? "" : "#version 450\n") << file.print(hlsl ? shader::hlsl() : shader::glsl())
               << kernel(*one.recording(), hlsl);
            written = written && bool(to.flush());
        });
        return !written;
    }
    shader::file file;
    shader_tests::for_each_function([&](const char* name, const auto& f) { file.add(recorded(name, f)); });
    file.add(shader::function("value_and_slopes", {"v", "l", "alpha", "F0"},
                              [](shader::vec3 v, shader::vec3 l, real alpha, real F0) {
                                  return shader_tests::value_and_slopes(v, l, alpha, F0);
                              })
                 .about("f_cos of GGX, df_cos/dalpha, df_cos/dF0"));
    for (const auto& to : {shader::cpp(), shader::cuda(), shader::glsl(), shader::glsl_es(), shader::hlsl(),
                           shader::wgsl(), shader::msl()})
        if (to.name == what) return !(std::ofstream(arguments[2]) << file.print(to));
    std::cerr << "no language " << what << '\n';
    return 2;
}
