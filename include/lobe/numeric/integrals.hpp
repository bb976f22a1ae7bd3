// Integrals for what has no closed form. Scalar types only.
#pragma once

#include <lobe/numeric/precision.hpp>

#include <array>
#include <limits>

namespace lobe::detail {

/// int g(x) dx over x > 0: the trapezoid rule after x = scale exp((pi/2) sinh t), which crowds nodes
/// towards 0 and infinity (Takahasi & Mori 1974). 112 evaluations of g, a number or a vector of them,
/// smooth in ln x and falling faster than x^-1.2.
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

/// int g(x) dx over low < x < high, the same with x = (low + high)/2 + (high - low)/2
/// tanh((pi/2) sinh t): the ends may be singular.
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

/// int g(x) dx from low to high for a g that is nearly a polynomial in each of `panels` parts:
/// Gauss-Legendre, 8 evaluations a part.
template <one_lane T, class G>
constexpr T short_integral(const T& low, const T& high, int panels, const G& g) {
    constexpr double node[] = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267, 0.9602898564975363};
    constexpr double weight[] = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745, 0.1012285362903763};
    const T half = (high - low) / T(2 * panels);
    T total(0);
    for (int panel = 0; panel < panels; ++panel) {
        const T middle = low + T(2 * panel + 1) * half;
        for (std::size_t i = 0; i < 4; ++i)
            total += T(weight[i]) * (g(middle - half * T(node[i])) + g(middle + half * T(node[i])));
    }
    return total * half;
}

}  // namespace lobe::detail
