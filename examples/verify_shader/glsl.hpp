// What makes GLSL compile as C++: GLM's functions and types, in a namespace of the shader's own.
#pragma once

#include "subject.hpp"

#include <glm/glm.hpp>

#include <cmath>
#include <limits>

namespace shader {

using namespace glm;

// GLSL leaves pow(x < 0, y) and pow(0, y <= 0) undefined: GPUs take exp2(y log2(x)), which is NaN or infinite there. C++ has an answer.
inline float pow(float x, float y) {
    if (x < 0 || (x == 0 && y <= 0)) return std::numeric_limits<float>::quiet_NaN();
    return std::pow(x, y);
}
template <length_t N>
vec<N, float> pow(const vec<N, float>& x, const vec<N, float>& y) {
    vec<N, float> out;
    for (length_t i = 0; i < N; ++i) out[i] = shader::pow(x[i], y[i]);
    return out;
}

}  // namespace shader
