// What one line `//! verify` of a GLSL file asks for. The translated shader fills these in, main.cpp gives them to the
// test kit.
#pragma once

#include <lobe/testkit/options.hpp>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <vector>

struct subject {
    struct light_sample {
        glm::vec3 l, weight;
        float pdf;
    };
    using vec2 = glm::vec2;
    using vec3 = glm::vec3;

    lobe::testkit::options options;
    bool world_space = false;  // n is oblique, else (0,0,1)
    unsigned points = 1024;    // of a sequence

    // One of these is set,
    vec3 (*f_cos)(vec3 n, vec3 v, vec3 l) = nullptr;
    float (*D)(vec3 n, vec3 m) = nullptr;
    vec3 (*F)(float cosine) = nullptr;
    vec2 (*point)(unsigned i) = nullptr;

    // and of these what the shader has.
    light_sample (*sample_light)(vec3 n, vec3 v, vec2 u) = nullptr;
    float (*pdf_light)(vec3 n, vec3 v, vec3 l) = nullptr;
    vec3 (*sample_normal)(vec3 n, vec2 u) = nullptr;
    float (*pdf_normal)(vec3 n, vec3 m) = nullptr;
    float (*G1)(vec3 n, vec3 v) = nullptr;
};

namespace shader {
std::vector<subject> requested();
}
