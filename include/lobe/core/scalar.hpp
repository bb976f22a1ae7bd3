// What every formula needs of a number: the scalar concept, select and all, pi, and the sine and cosine of a turn.
#pragma once

#include <lobe/core/cpp20.hpp>

#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace lobe {

/// A number that formulas are written in: float, double, a SIMD pack, a dual number, a multiprecision number.
/// Arithmetic and an order are enough; `sqrt`, `log`, ... and, for packs, `select` and `all` are found by ADL.
template <class T>
concept scalar = !std::integral<T> && requires(const T a, const T b) {
    { T(1) } -> std::same_as<T>;
    { -a } -> std::convertible_to<T>;
    { a + b } -> std::convertible_to<T>;
    { a - b } -> std::convertible_to<T>;
    { a* b } -> std::convertible_to<T>;
    { a / b } -> std::convertible_to<T>;
    a < b;
    a > b;
};

/// `mask ? a : b` as a function: packs bring their own overload, vectors have one in vector.hpp.
/// Both sides are evaluated: debug builds that trap NaNs see the one that is not taken, too. No 0/0 there: `quotient`.
template <scalar T>
constexpr T select(bool mask, const T& a, const T& b) {
    return mask ? a : b;
}

/// a/b where the mask holds, and 0 where it does not: for a b that may be 0 there. Neither 0/0 nor 1/0 is computed,
/// so debug builds that trap NaNs run through (Clang's need -ffp-exception-behavior=maytrap).
/// Compilers make one of two selects on one mask: in a loop it costs an instruction or less (docs/performance.md).
template <class Mask, scalar T>
[[gnu::always_inline]] constexpr T quotient(const Mask& mask, const T& a, const T& b) {
    return select(mask, a / select(mask, b, T(1)), T(0));
}

#ifdef __GNUC__
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wfloat-equal"
#endif
/// a == b in each lane, where exactly that is meant: the one place that compilers which warn of it have to be told so.
template <scalar T>
constexpr auto equal(const T& a, const T& b) {
    return a == b;
}
#ifdef __GNUC__
#pragma GCC diagnostic pop
#endif

/// Does a condition hold in every lane? One number has one lane.
constexpr bool all(bool mask) { return mask; }

template <scalar T>
constexpr T larger(const T& a, const T& b) {
    return select(a < b, b, a);
}

template <scalar T>
constexpr T smaller(const T& a, const T& b) {
    return select(b < a, b, a);
}

/// |x|, by `abs` where T has one.
template <scalar T>
constexpr T absolute(const T& x) {
    using std::abs;
    if constexpr (requires {
                      { abs(x) } -> std::same_as<T>;
                  })
        return abs(x);
    else
        return select(x < T(0), -x, x);
}

namespace detail {

/// Neither infinite nor a NaN, in each lane: inf - inf is a NaN, which is not below 1.
template <scalar T>
constexpr auto finite(const T& x) {
    return x - x < T(1);
}

template <class T>
struct lane {
    using type = T;
};
template <class T>
    requires requires { typename T::value_type; } && std::floating_point<typename T::value_type>
struct lane<T> {
    using type = typename T::value_type;
};

}  // namespace detail

namespace detail {

/// The smallest positive number in a lane of T that has all its digits; its reciprocal is finite.
template <scalar T>
constexpr T smallest() {
    if constexpr (std::numeric_limits<typename lane<T>::type>::is_specialized)
        return T((std::numeric_limits<typename lane<T>::type>::min)());
    else
        return T(1e-300);
}

}  // namespace detail

/// The number in one lane of a pack, or in one component of a vector: float for xsimd::batch<float> and glm::vec3.
template <class T>
using lane_t = typename detail::lane<T>::type;

namespace detail {

/// The largest finite number in a lane of T. Infinity stays out of formulas: inf - inf and 0 * inf are NaN.
template <scalar T>
constexpr T largest() {
    if constexpr (std::numeric_limits<lane_t<T>>::is_specialized)
        return T((std::numeric_limits<lane_t<T>>::max)());
    else
        return T(1e300);
}

}  // namespace detail

/// Above the horizon are cosines of more than this, 2^-60 in float and 2^-500 in double. Below it squares underflow:
/// that of v + l, where l nears -v, and the product of two cosines.
template <scalar T>
constexpr T horizon() {
    return T(static_cast<lane_t<T>>(std::same_as<lane_t<T>, float> ? 0x1p-60 : 0x1p-500));
}

/// pi to the precision of T; types that can be read from a string (multiprecision) get 100 digits, others
/// those of double.
template <scalar T>
constexpr T pi() {
    if constexpr (std::is_constructible_v<T, const char*>)
        return T(
            "3.141592653589793238462643383279502884197169399375105820974944592307816406286208998628034825342117068");
    else if constexpr (std::floating_point<lane_t<T>>)
        return T(static_cast<lane_t<T>>(3.141592653589793238462643383279502884L));
    else
        return T(3.141592653589793);
}

/// 1/pi.
template <scalar T>
constexpr T inv_pi() {
    if constexpr (std::floating_point<lane_t<T>>)
        return T(static_cast<lane_t<T>>(0.318309886183790671537767526745028724L));
    else
        return T(1) / pi<T>();
}

template <scalar T>
struct sincos_result {
    T sin, cos;
};

namespace detail {

/// std::bit_cast, which the libraries of older compilers for the web lack.
template <class To, class From>
constexpr To bit_cast(const From& x) {
    return __builtin_bit_cast(To, x);
}

/// The nearest number of quarter turns to u, halves up. A quarter turn maps (sin, cos) to (cos, -sin).
template <scalar T>
struct quarter_turns {
    T number;

    constexpr explicit quarter_turns(const T& u) {
        // summed: nested selects stay scalar
        const auto step = [&](float at) { return select(u < T(at), T(0), T(1)); };
        number = step(0.125f) + step(0.375f) + step(0.625f) + step(0.875f);
    }
    constexpr sincos_result<T> rotated(const T& sine, const T& cosine) const {
        const auto one = equal(number, T(1)), two = equal(number, T(2)), three = equal(number, T(3));
        const auto odd = one || three;
        const T s = select(odd, cosine, sine);
        const T c = select(odd, sine, cosine);
        return {select(two || three, -s, s), select(one || two, -c, c)};
    }
};

/// The same of one float, by its bits, which takes half the instructions.
template <>
struct quarter_turns<float> {
    std::uint32_t turns;
    float number;

    constexpr explicit quarter_turns(float u)
        : turns((static_cast<std::uint32_t>(static_cast<std::int32_t>(8.0f * u)) + 1u) >> 1u),
          number(static_cast<float>(static_cast<std::int32_t>(turns))) {}
    constexpr sincos_result<float> rotated(float sine, float cosine) const {
        const auto s = detail::bit_cast<std::uint32_t>(sine), c = detail::bit_cast<std::uint32_t>(cosine);
        const std::uint32_t swapped = (s ^ c) & (0u - (turns & 1u));
        return {detail::bit_cast<float>(s ^ swapped ^ (turns & 2u) << 30u),
                detail::bit_cast<float>(c ^ swapped ^ ((turns + 1u) & 2u) << 30u)};
    }
};

}  // namespace detail

/// sin(2 pi u) and cos(2 pi u), u in turns.
///
/// The nearest quarter turn is subtracted, which is exact, and two minimax polynomials cover the rest,
/// |r| <= 1/8: sin(2 pi r) = r (2 pi + r^2 P(r^2)), cos(2 pi r) = 1 + r^2 Q(r^2). (Remez, relative error below 1e-8 in
/// float, 3e-17 in double, coefficients rounded.) No branch and no libm call, so it vectorises.
/// Domain: u in [-1/8, 9/8]; of a float, |u| of 2^28 and more and a NaN are undefined.
/// Error: at most 2 ULP in float and double. Other scalars call `sin` and `cos` by ADL.
/// (Inlined by force: docs/design.md.)
template <scalar T>
[[gnu::always_inline]] constexpr sincos_result<T> sincos_2pi(const T& u) {
    if constexpr (!std::same_as<lane_t<T>, float> && !std::same_as<lane_t<T>, double>) {
        using std::cos, std::sin;
        return {sin(T(2) * pi<T>() * u), cos(T(2) * pi<T>() * u)};
    } else {
        const detail::quarter_turns<T> turns(u);
        const T r = u - turns.number * T(0.25f);
        const T t = r * r;
        T sine, cosine;
        if constexpr (std::same_as<lane_t<T>, float>) {
            const T p = T(-41.341673f) + t * (T(81.593937f) + t * T(-75.453396f));
            const T q = T(-19.739208694f) + t * (T(64.939326f) + t * (T(-85.443742f) + t * T(59.245964f)));
            sine = r * T(6.2831854820f) + r * (T(-1.74845560e-7f) + t * p);  // 2 pi in two parts
            cosine = T(1) + t * q;
        } else {
            const T p =
                T(-41.34170224039967441) +
                t * (T(81.60524927596822842) + t * (T(-76.70585970878480164) +
                                                    t * (T(42.05868550676149512) + t * (T(-15.09382932284615955) +
                                                                                        t * T(3.781366407158700742)))));
            const T q = T(-19.73920880217871707) +
                        t * (T(64.93939402266801339) +
                             t * (T(-85.45681720654004791) +
                                  t * (T(60.24464133161101936) +
                                       t * (T(-26.42625114037281938) +
                                            t * (T(7.903101635511589591) + t * T(-1.697020036564926046))))));
            sine = r * T(6.283185307179586) + r * (T(2.4492935982947064e-16) + t * p);
            cosine = T(1) + t * q;
        }
        return turns.rotated(sine, cosine);
    }
}

}  // namespace lobe
