// One input of the fuzzer: its bytes as parameters, directions and random numbers.
#pragma once

#include <lobe/core/vector.hpp>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace fuzz {

/// Every bit of x in every bit of the result: the finaliser of Steele, Lea & Flood 2014, "Fast Splittable Pseudorandom
/// Number Generators".
constexpr std::uint64_t mixed(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

struct named_value {
    const char* name;
    double value;
};

/// Words of 8 bytes: first the parameters of a model, then, from `end_of_parameters()` on, a case (v, l, u) for it.
/// Case 0 reads the bytes as they are; every other has three words in four from a hash of the input and of its number.
/// So has what the bytes do not reach.
class input {
public:
    input(const std::uint8_t* data, std::size_t size) : bytes(data), length(size), seed(size) {
        for (std::size_t i = 0; i < (size + 7) / 8; ++i) seed = mixed(seed ^ stored(i)) + 0x9e3779b97f4a7c15u;
    }

    std::uint64_t word() {
        const std::size_t at = position++;
        const std::uint64_t hash = mixed(seed + mixed(at + (number << 32)));
        if (8 * at >= length) return hash;
        return number == 0 || hash % 4 == 0 ? stored(at) : mixed(hash);
    }
    std::uint64_t below(std::uint64_t n) { return word() % n; }

    void end_of_parameters() { first_of_case = position; }
    void start_case(std::uint64_t n) {
        number = n;
        position = first_of_case;
    }

    /// Keeps a parameter for the report.
    template <class T>
    T keep(const char* name, const T& value) {
        if (kept < parameters.size()) parameters[kept++] = {name, static_cast<double>(value)};
        return value;
    }
    template <class Visit>
    void for_each_parameter(const Visit& visit) const {
        for (std::size_t i = 0; i < kept; ++i) visit(parameters[i]);
    }

    template <class Visit>
    void for_each_byte(const Visit& visit) const {
        for (std::size_t i = 0; i < length; ++i) visit(bytes[i]);
    }

private:
    std::uint64_t stored(std::size_t i) const {
        std::uint64_t word = 0;
        std::memcpy(&word, bytes + 8 * i, length - 8 * i < 8 ? length - 8 * i : 8);
        return word;
    }

    const std::uint8_t* bytes;
    std::size_t length, position = 0, first_of_case = 0, kept = 0;
    std::uint64_t seed, number = 0;
    std::array<named_value, 40> parameters{};
};

/// In [0,1).
template <class T>
T uniform(std::uint64_t word) {
    return static_cast<T>(word >> (64 - std::numeric_limits<T>::digits)) * std::numeric_limits<T>::epsilon() / T(2);
}

/// In [0,1), with the ends, the quarters and the eighths that formulas branch at, and numbers as small as they get.
template <class T>
T number_below_1(input& in) {
    const std::uint64_t word = in.word(), rest = mixed(word);
    switch (word % 16) {
        case 0: return T(0);
        case 1: return T(1) - std::numeric_limits<T>::epsilon() / T(2);
        case 2: return T(rest % 8) / T(8);
        case 3:
            return std::ldexp(uniform<T>(rest), -static_cast<int>(rest % 140));  // float: down to the smallest there is
        case 4: return std::numeric_limits<T>::denorm_min();
        default: return uniform<T>(rest);
    }
}

/// In [0,1].
template <class T>
T share(input& in) {
    const std::uint64_t word = in.word();
    return word % 8 == 0 ? T(1) : word % 8 == 1 ? T(0) : uniform<T>(mixed(word));
}

/// Evenly spread in the logarithm, with both ends.
template <class T>
T between(input& in, double low, double high) {
    const std::uint64_t word = in.word();
    if (word % 16 == 0) return static_cast<T>(low);
    if (word % 16 == 1) return static_cast<T>(high);
    const T x = static_cast<T>(low * std::pow(high / low, uniform<double>(mixed(word))));
    return x < static_cast<T>(low) ? static_cast<T>(low) : x > static_cast<T>(high) ? static_cast<T>(high) : x;
}

/// A number whose exponent is as likely as any other, of either sign, or zero.
template <class T>
T any_exponent(input& in) {
    const std::uint64_t word = in.word();
    const T x = word % 16 == 0 ? T(0)
                               : std::ldexp(T(0.5) + uniform<T>(mixed(word)) / T(2),
                                            -static_cast<int>(word % (sizeof(T) == 4 ? 151u : 1076u)));
    return word / 16 % 2 ? x : -x;
}

/// Of unit length but for a few ULP, two components of any size, in any of the three places. (-ffast-math promises
/// nothing there.)
template <class T>
lobe::vec3<T> any_direction(input& in) {
#ifdef __FAST_MATH__
    return {T(0), T(in.below(2) ? 0.6 : -0.6), T(0.8)};
#endif
    T a = any_exponent<T>(in), b = any_exponent<T>(in);
    if (a * a + b * b > T(1)) a /= T(2), b /= T(2);
    const std::uint64_t word = in.word();
    const T stretch = T(1) + static_cast<T>(static_cast<int>(word % 5) - 2) * std::numeric_limits<T>::epsilon(),
            rest = std::sqrt(T(1) - a * a - b * b);
    const T c = word / 8 % 4 ? rest * stretch : -rest * stretch;
    return word / 32 % 3 == 0   ? lobe::vec3<T>{c, a, b}
           : word / 32 % 3 == 1 ? lobe::vec3<T>{b, c, a}
                                : lobe::vec3<T>{a, b, c};
}

/// A unit vector: anywhere, along the normal, near it or near the horizon, at it, below; among the axes and off them by
/// the smallest numbers; of any components.
template <class T>
lobe::vec3<T> direction(input& in) {
    const std::uint64_t word = in.word(), where = word >> 8;
    const double x = uniform<double>(mixed(where)), y = uniform<double>(mixed(where + 1));
    double z = x > 1e-6 ? x : 1e-6, sine = std::sqrt((1 - z) * (1 + z));
    switch (word % 16) {
        case 0: return {T(0), T(0), T(x < 0.8 ? 1 : -1)};
        case 1:
            return {std::numeric_limits<T>::denorm_min() * T(x < 0.5 ? 1 : -3), std::numeric_limits<T>::denorm_min(),
                    T(1)};
        case 2: sine = 0.999 * std::pow(10, -12 * x), z = std::sqrt((1 - sine) * (1 + sine)); break;
        case 3: z = 0, sine = 1; break;
        case 4: z = 1e-6, sine = std::sqrt((1 - z) * (1 + z)); break;
        case 5:
        case 6: z = std::pow(10, -6 * x), sine = std::sqrt((1 - z) * (1 + z)); break;
        case 7: z = -z; break;
        case 9: return any_direction<T>(in);
        case 8: z = -std::pow(10, -40 * x), sine = std::sqrt((1 - z) * (1 + z)); break;
        default: break;
    }
    const double turn = 6.283185307179586 * y;
    double c = std::cos(turn), s = std::sin(turn);
    switch (word / 16 % 8) {
        case 0: c = y < 0.5 ? 1 : -1, s = 0; break;
        case 1: c = 0, s = y < 0.5 ? 1 : -1; break;
        default: break;
    }
    return {static_cast<T>(sine * c), static_cast<T>(sine * s), static_cast<T>(z)};
}

/// A light for the view v and the width: any, or v, or -v, or what all but cancels v, or where the perfect mirror or a
/// facet as steep as the width sends it.
template <class T>
lobe::vec3<T> light(input& in, const lobe::vec3<T>& v, const lobe::vec2<T>& width) {
    const std::uint64_t word = in.word(), where = word >> 8;
    switch (word % 8) {
        case 0: return v;
        case 1: return -v;
        case 2: return {-v.x, -v.y, v.z};
        case 3: return {-v.x, v.y, v.z};
        case 4: {
            const double reach = std::pow(10, 3 * uniform<double>(mixed(where)) - 2),
                         turn = 6.283185307179586 * uniform<double>(mixed(where + 1));
            double m[] = {reach * static_cast<double>(width.x) * std::cos(turn),
                          reach * static_cast<double>(width.y) * std::sin(turn), 1};
            const double length = std::sqrt(m[0] * m[0] + m[1] * m[1] + 1),
                         w[] = {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
            for (double& x : m) x /= length;
            const double v_m = w[0] * m[0] + w[1] * m[1] + w[2] * m[2];
            const lobe::vec3<T> l{static_cast<T>(2 * v_m * m[0] - w[0]), static_cast<T>(2 * v_m * m[1] - w[1]),
                                  static_cast<T>(2 * v_m * m[2] - w[2])};
            return l;
        }
        case 5: {
            const lobe::vec3<T> l{-v.x, -v.y, any_exponent<T>(in)};
            return std::abs(lobe::dot(l, l) - T(1)) < T(16) * std::numeric_limits<T>::epsilon() ? l
                                                                                                : any_direction<T>(in);
        }
        default: return direction<T>(in);
    }
}

/// Any bits at all, as a number.
template <class T>
T any_number(input& in) {
    const std::uint64_t word = in.word();
    if (word % 4 == 0) return static_cast<T>(2 * uniform<double>(mixed(word)) - 1);
    if constexpr (sizeof(T) == 4)
        return std::bit_cast<T>(static_cast<std::uint32_t>(word >> 32));
    else
        return std::bit_cast<T>(word);
}

/// Of any bits, what has a sine and a cosine: `sincos_2pi` of a float is undefined elsewhere.
template <class T>
T any_turns(input& in) {
    const T u = any_number<T>(in);
    return std::abs(u) < T(1 << 28) ? u : T(0);
}

template <class T>
lobe::vec3<T> any_vector(input& in) {
    const T x = any_number<T>(in), y = any_number<T>(in);
    return {x, y, any_number<T>(in)};
}

}  // namespace fuzz
