// Numbers as text, whatever the locale, and the inputs that a value was computed from as C++ with all their digits,
// ready for a unit test.
#pragma once

#include <lobe/core/vector.hpp>
#include <lobe/testkit/measure/numbers.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>
#include <type_traits>

namespace lobe::testkit::detail {

/// Text of limited length, which a signal handler may write, too: it allocates nothing. What does not fit is cut off.
class line {
public:
    line& operator<<(std::string_view text) {
        const std::size_t n = (std::min)(text.size(), data.size() - used);
        std::copy_n(text.begin(), n, data.begin() + static_cast<std::ptrdiff_t>(used));
        used += n;
        return *this;
    }
    /// As %.{digits}g prints it in the C locale.
    line& number(double x, int digits) {
        if (!is_finite(x)) return *this << (is_nan(x) ? "nan" : is_negative(x) ? "-inf" : "inf");
        std::array<char, 40> text{};
        const auto end =
            std::to_chars(text.data(), text.data() + text.size(), x, std::chars_format::general, digits).ptr;
        return *this << std::string_view(text.data(), static_cast<std::size_t>(end - text.data()));
    }
    std::string_view text() const { return {data.data(), used}; }

private:
    std::array<char, 640> data{};
    std::size_t used = 0;
};

inline std::string number(double x, int digits = 6) { return std::string(line{}.number(x, digits).text()); }
/// A share as "12 %": two digits, or whole ones.
inline std::string percent(double share) {
    const double x = 100 * share;
    return (std::abs(x) < 99.5 ? number(x, 2) : number(std::round(x))) + " %";
}

template <class T>
void write_literal(line& out, T x) {
    line one;
    one.number(static_cast<double>(x), std::is_same_v<T, float> ? 9 : 17);
    out << one.text();
    if (!is_finite(static_cast<double>(x))) return;
    if (one.text().find_first_of(".e") == std::string_view::npos) out << ".0";
    if (std::is_same_v<T, float>) out << "f";
}
template <glm::length_t N, class T>
void write_literal(line& out, std::string_view name, const glm::vec<N, T, glm::defaultp>& w) {
    out << (std::is_same_v<T, float> ? "glm::vec" : "glm::dvec") << (N == 2 ? "2 " : "3 ") << name << "{";
    for (glm::length_t i = 0; i < N; ++i) {
        if (i) out << ", ";
        write_literal(out, w[i]);
    }
    out << "}; ";
}
template <class T>
std::string literal(T x) {
    line out;
    write_literal(out, x);
    return std::string(out.text());
}
template <glm::length_t N, class T>
std::string literal(std::string_view name, const glm::vec<N, T, glm::defaultp>& w) {
    line out;
    write_literal(out, name, w);
    return std::string(out.text());
}

/// Directions and numbers that a value was computed from.
template <class T>
struct place {
    vec3<T> v{}, l{};
    vec3<T> u{};
    bool has_v = true, has_l = true;
    bool both_sides = false;  // below is as good as above
    int numbers = 0;          // how many of u there are
    const char* first = "v";  // what v is: a normal, in places of a distribution
    void write(line& out) const {
        if (has_v) write_literal(out, first, v);
        if (has_l) write_literal(out, "l", l);
        if (numbers == 2) write_literal(out, "u", vec2<T>(u.x, u.y));
        if (numbers == 3) write_literal(out, "u", u);
    }
    std::string text() const {
        line out;
        write(out);
        return std::string(out.text());
    }
};

}  // namespace lobe::testkit::detail
