// Inputs of recorded functions: random ones, and those at which formulas break.
#pragma once

#include "functions.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace shader_tests {

/// Views at all heights above the horizon, also grazing ones; lights anywhere; alpha from 1e-4 to 1, evenly in
/// its logarithm.
class random_inputs {
public:
    input<float> operator()() {
        lobe::vec3<float> l = direction(uniform() < 0.1f ? std::exp(-20 * uniform()) : uniform());
        if (uniform() < 0.1f) l.z = -l.z;
        return {direction(uniform() < 0.2f ? std::exp(-20 * uniform()) : uniform()),
                l,
                {uniform(), uniform()},
                std::exp(-9.2f * uniform()),
                uniform()};
    }
    float uniform() { return float(engine() >> 8) * 0x1p-24f; }

private:
    lobe::vec3<float> direction(float z) {
        const float phi = 6.2831853f * uniform(), s = std::sqrt((1 - z) * (1 + z));
        return {s * std::cos(phi), s * std::sin(phi), z};
    }
    std::mt19937 engine{17};
};

/// The corners: along the normal, at and below the horizon, antiparallel, the ends of the square, the narrowest width.
inline std::vector<input<float>> extreme_inputs() {
    using v3 = lobe::vec3<float>;
    const float near = 1 - std::numeric_limits<float>::epsilon() / 2;
    const std::array directions{v3{0, 0, 1},        v3{1, 0, 0},         v3{0, -1, 0x1p-61f},
                                v3{-0.6f, 0, 0.8f}, v3{0.6f, 0, 0.8f},   v3{1e-8f, 0, 1},
                                v3{0, 1, 1e-6f},    v3{-1, 0, 0x1p-59f}, v3{0.70710677f, 0.70710677f, 1e-20f}};
    std::vector<input<float>> all;
    for (const v3& v : directions)
        for (const v3& l : directions)
            for (const v3& to : {l, v3{l.x, l.y, -l.z}, v3{-l.x, -l.y, l.z}})
                for (const lobe::vec2<float> u :
                     {lobe::vec2<float>{0, 0}, {near, near}, {0.5f, 0.125f}, {0x1p-24f, 0.875f}})
                    for (const float width : {1e-4f, 0.3f, 1.0f})
                        for (const float x : {0.0f, 0.5f, 1.0f}) all.push_back({v, to, u, width, x});
    return all;
}

/// The numbers of a result.
struct numbers {
    std::array<float, 7> at;
    std::size_t count = 0;
    void add(float x) { at[count++] = x; }
};

/// ... of lobe's types or of the printed ones.
template <class R, class Numbers>
void collect(const R& r, Numbers& to) {
    if constexpr (requires {
                      r.pdf;
                      r.l;
                  })
        collect(r.l, to), collect(r.weight, to), to.add(r.pdf);
    else if constexpr (requires { r.pdf; })
        collect(r.f_cos, to), to.add(r.pdf);
    else if constexpr (requires { r.irradiance; })
        collect(r.radiance, to), collect(r.irradiance, to);
    else if constexpr (requires { r.bias; })
        to.add(r.scale), to.add(r.bias);
    else if constexpr (requires { r.z; })
        to.add(r.x), to.add(r.y), to.add(r.z);
    else if constexpr (requires { r.x; })
        to.add(r.x), to.add(r.y);
    else
        to.add(r);
}
template <class R>
numbers numbers_of(const R& r) {
    numbers all;
    collect(r, all);
    return all;
}

}  // namespace shader_tests
