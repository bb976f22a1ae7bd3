// Everything of lobe that a shader can have, for any scalar type: recorded by write.cpp, computed by the tests.
#pragma once

#include <lobe/lobe.hpp>

namespace shader_tests {

template <class T>
struct input {
    lobe::vec3<T> v, l;
    lobe::vec2<T> u;
    T width, x;

    constexpr lobe::alpha<T> a() const { return lobe::alpha<T>(width); }
    constexpr lobe::alpha_xy<T> xy() const { return {width, width * T(0.5f)}; }
    constexpr lobe::vec3<T> color() const { return {x, x * T(0.5f), x * T(0.25f)}; }
    constexpr lobe::vec3<T> up() const { return {v.x, v.y, lobe::absolute(v.z) + T(0.01f)}; }
    constexpr auto metal() const {
        return lobe::microfacet{lobe::ggx{a()}, lobe::smith_correlated{}, lobe::schlick{color()}};
    }
    constexpr auto two_lobes() const {
        return lobe::sum{lobe::weighted{x, metal()}, lobe::weighted{T(1) - x, lobe::lambert{color()}}};
    }
    constexpr auto all_bounces() const {
        return lobe::compensated{metal(), lobe::smith_multiscatter{lobe::dfg_fit_cheap{}}.forward()};
    }
};

/// A small table, for llvmpipe compiles a large one for minutes; write.cpp has it as shaders do.
inline const auto& small_table() {
    static const auto once = lobe::bake_dfg<float>(lobe::smith_correlated{}, {.size = 5});
    return once;
}
template <class T>
struct terms_of {
    template <class N, class Masking>
    static constexpr bool describes = true;
    lobe::dfg_terms<T> operator()(const T& cosine, const lobe::alpha<T>& a) const {
        return small_table().parts().terms(cosine, a);
    }
    lobe::dfg_terms<T> average(const lobe::alpha<T>& a) const { return small_table().parts().average(a); }
};

#define SHADER_FUNCTION(name, ...)                                                                                     \
    template <class T>                                                                                                 \
    constexpr auto name(const input<T>& in) {                                                                          \
        using namespace lobe;                                                                                          \
        return __VA_ARGS__;                                                                                            \
    }
#include "functions.inc"
#undef SHADER_FUNCTION

/// Calls g(name, function of an `input`) for each.
template <class G>
void for_each_function(const G& g) {
#define SHADER_FUNCTION(name, ...) g(#name, [](const auto& in) { return name(in); });
#include "functions.inc"
#undef SHADER_FUNCTION
}

}  // namespace shader_tests
