// Integrals and roots for what has no closed form. Scalar types only.
#pragma once

#include <lobe/core/scalar.hpp>

#include <array>
#include <limits>

namespace lobe::detail {

/// One number, not a pack of them: something that an `if` can look at.
template <class T>
concept one_lane = scalar<T> && requires(const T a) {
    { a < a } -> std::convertible_to<bool>;
};

/// What tables and integrals are computed in: double at least.
template <class T>
using at_least_double = std::conditional_t<std::same_as<T, float>, double, T>;

/// More digits than double has.
template <class T>
inline constexpr bool beyond_double = std::numeric_limits<lane_t<T>>::is_specialized && std::numeric_limits<lane_t<T>>::digits > 64;

/// The cosine that stands for zero: its square times the square of a width (1e-4 in float) is still a number.
template <scalar T>
constexpr T zero_cosine() {
    if constexpr (std::same_as<lane_t<T>, float>)
        return T(0x1p-44f);
    else
        return T(0x1p-490);
}

/// int g(x) dx over x > 0: the trapezoid rule after x = scale exp((pi/2) sinh t), which crowds nodes towards 0 and infinity
/// (Takahasi & Mori 1974). 112 evaluations of g, a number or a vector of them, smooth in ln x and falling faster than x^-1.2.
/// Error: below 1e-9 of int |g| where g turns within a few powers of ten around `scale`.
template <one_lane T, class G>
constexpr auto integral_to_infinity(const T& scale, const G& g) {
    using std::exp;
    const T step = T(8.5f) / T(112), quarter = pi<T>() / T(2), grow = exp(step);
    T et = exp(T(-3.5f) + step / T(2));
    decltype(g(scale)) total(T(0));
    for (int i = 0; i < 112; ++i, et *= grow) {
        const T shrink = T(1) / et, x = scale * exp(quarter / T(2) * (et - shrink));
        total += g(x) * (x * (et + shrink));
    }
    return total * (quarter / T(2) * step);
}

/// int g(x) dx over low < x < high, the same with x = (low + high)/2 + (high - low)/2 tanh((pi/2) sinh t): the ends may be singular.
template <one_lane T, class G>
constexpr auto integral_between(const T& low, const T& high, const G& g) {
    using std::exp;
    const T step = T(6.5f) / T(112), quarter = pi<T>() / T(2), grow = exp(step), width = high - low;
    T et = exp(T(-3.25f) + step / T(2));
    decltype(g(low)) total(T(0));
    for (int i = 0; i < 112; ++i, et *= grow) {
        const T shrink = T(1) / et, e = exp(quarter * (et - shrink)), part = T(1) / (T(1) + e);
        total += g(e < T(1) ? low + width * e * part : high - width * part) * (e * part * part * (et + shrink));
    }
    return total * (width * quarter * step);
}

/// int g(x) dx from low to high for a g that is nearly a polynomial in each of `panels` parts: Gauss-Legendre, 8 evaluations a part.
template <one_lane T, class G>
constexpr T short_integral(const T& low, const T& high, int panels, const G& g) {
    constexpr double node[] = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267, 0.9602898564975363};
    constexpr double weight[] = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745, 0.1012285362903763};
    const T half = (high - low) / T(2 * panels);
    T total(0);
    for (int panel = 0; panel < panels; ++panel) {
        const T middle = low + T(2 * panel + 1) * half;
        for (std::size_t i = 0; i < 4; ++i) total += T(weight[i]) * (g(middle - half * T(node[i])) + g(middle + half * T(node[i])));
    }
    return total * half;
}

template <scalar T>
struct value_and_slope {
    T value, slope;
};

/// The x in [low, high] where an increasing function is zero; `f(x)` returns its value and slope. Newton's method, bisecting
/// where Newton leaves the bracket, until steps are small enough for the next, as small as their square, not to show. Error: the
/// rounding of f over its slope, or 4 ULP of the bracket's ends.
template <one_lane T, class F>
constexpr T root_of_increasing(T low, T high, T x, const F& f) {
    using std::abs, std::sqrt;
    const T epsilon = std::numeric_limits<T>::epsilon(), precision = T(4) * epsilon, quadratic = sqrt(epsilon) / T(8);
    if (!(x > low && x < high)) x = (low + high) / T(2);
    for (int i = 0; i < 100; ++i) {
        const value_and_slope<T> here = f(x);
        if (equal(here.value, T(0))) break;
        (here.value < T(0) ? low : high) = x;
        const T newton = equal(here.slope, T(0)) ? low : x - here.value / here.slope;
        const bool inside = newton > low && newton < high;
        const T next = inside ? newton : (low + high) / T(2);
        const T step = abs(next - x);
        x = next;
        if (!(step > (inside ? quadratic : precision) * abs(x)) || !(high - low > precision * larger(abs(low), abs(high)))) break;
    }
    return x;
}

}  // namespace lobe::detail
