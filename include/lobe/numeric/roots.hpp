// Roots of increasing functions. Scalar types only.
#pragma once

#include <lobe/numeric/precision.hpp>

#include <cmath>
#include <limits>

namespace lobe::detail {

template <scalar T>
struct value_and_slope {
    T value, slope;
};

/// The x in [low, high] where an increasing function is zero; `f(x)` returns its value and slope.
/// Newton's method, bisecting where Newton leaves the bracket, until steps are small enough for the next,
/// as small as their square, not to show.
/// Error: the rounding of f over its slope, or 4 ULP of the bracket's ends.
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
        if (!(step > (inside ? quadratic : precision) * abs(x)) ||
            !(high - low > precision * larger(abs(low), abs(high))))
            break;
    }
    return x;
}

}  // namespace lobe::detail
