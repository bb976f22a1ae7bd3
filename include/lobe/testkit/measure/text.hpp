// Numbers as text, and the inputs that a value was computed from as C++ with all their digits, ready for a unit test.
#pragma once

#include <lobe/core/vector.hpp>

#include <cmath>
#include <cstdio>
#include <string>
#include <type_traits>

namespace lobe::testkit::detail {

inline std::string number(double x, const char* format = "%.6g") {
    char text[40];
    std::snprintf(text, sizeof text, format, std::isnan(x) ? std::abs(x) : x);  // not "-nan"
    return text;
}

template <class T>
std::string literal(T x) {
    std::string text = number(static_cast<double>(x), std::is_same_v<T, float> ? "%.9g" : "%.17g");
    if (!std::isfinite(x)) return text;
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    return text + (std::is_same_v<T, float> ? "f" : "");
}
template <glm::length_t N, class T>
std::string literal(const char* name, const glm::vec<N, T, glm::defaultp>& w) {
    std::string text =
        std::string(std::is_same_v<T, float> ? "glm::vec" : "glm::dvec") + std::to_string(N) + " " + name + "{";
    for (glm::length_t i = 0; i < N; ++i) text += (i ? ", " : "") + literal(w[i]);
    return text + "}; ";
}

/// Directions and numbers that a value was computed from.
template <class T>
struct place {
    vec3<T> v{}, l{};
    vec3<T> u{};
    bool has_v = true, has_l = true;
    int numbers = 0;          // how many of u there are
    const char* first = "v";  // what v is: a normal, in places of a distribution
    std::string text() const {
        return (has_v ? literal(first, v) : "") + (has_l ? literal("l", l) : "") +
               (numbers == 2   ? literal("u", vec2<T>(u.x, u.y))
                : numbers == 3 ? literal("u", u)
                               : "");
    }
};

}  // namespace lobe::testkit::detail
