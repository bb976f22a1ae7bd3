// What C++ written by SPIRV-Cross needs: GLM's functions and types, in a namespace of the shader's own.
#pragma once

#include "subject.hpp"

#include <glm/ext.hpp>
#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>

namespace shader {

using namespace glm;

// GLSL leaves pow(x < 0, y) and pow(0, y <= 0) undefined: GPUs take exp2(y log2(x)), which is NaN or infinite there.
// C++ has an answer.
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

// std::array<std::array<...>> takes no list of lists.
template <class T, std::size_t N>
struct array {
    T values[N] = {};
    array() = default;
    array(std::initializer_list<T> list) { std::copy_n(list.begin(), (std::min)(N, list.size()), values); }
    T& operator[](std::size_t i) { return values[i]; }
    const T& operator[](std::size_t i) const { return values[i]; }
};

struct spirv_cross_shader;
struct FragmentResources {
    void init(spirv_cross_shader&) {}
};

}  // namespace shader
