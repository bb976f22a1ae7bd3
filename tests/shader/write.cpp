// Prints the functions of functions.inc: write LANGUAGE FILE
#include "functions.hpp"

#include <lobe/shader.hpp>

#include <fstream>
#include <iostream>

using lobe::shader::real;

int main(int, char** arguments) {
    lobe::shader::file file;
    shader_tests::for_each_function([&](const char* name, const auto& f) {
        file.add(lobe::shader::function(
            name, {"v", "l", "u", "width", "x"},
            [&](lobe::shader::vec3 v, lobe::shader::vec3 l, lobe::shader::vec2 u, real width, real x) {
                return f(shader_tests::input<real>{v, l, u, width, x});
            }));
    });
    for (const auto& to : {lobe::shader::cpp(), lobe::shader::cuda(), lobe::shader::glsl(), lobe::shader::glsl_es(),
                           lobe::shader::hlsl(), lobe::shader::wgsl(), lobe::shader::msl()})
        if (to.name == arguments[1]) return !(std::ofstream(arguments[2]) << file.print(to));
    std::cerr << "no language " << arguments[1] << '\n';
    return 2;
}
