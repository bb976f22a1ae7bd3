// Special functions that the standard library lacks.
#pragma once

#include <lobe/numeric/precision.hpp>

namespace lobe::detail {

/// (e^x - 1)/x, 1 at x = 0. Error: 3 ULP.
template <scalar T>
constexpr T expm1_ratio(const T& x) {
    using std::expm1;
    const auto zero = equal(x, T(0));
    return select(zero, T(1), expm1(x) / select(zero, T(1), x));
}

/// ln(1 + x)/x, 1 at x = 0; x > -1. Error: 3 ULP.
template <scalar T>
constexpr T log1p_ratio(const T& x) {
    using std::log1p;
    const auto zero = equal(x, T(0));
    return select(zero, T(1), log1p(x) / select(zero, T(1), x));
}

/// The continued fraction a1/(b1 + a2/(b2 + ...)) by the modified method
/// of Lentz (Thompson & Barnett 1986). Scalar types only.
template <one_lane T, class Numerator, class Denominator>
constexpr T continued_fraction(const Numerator& a, const Denominator& b) {
    using std::abs;
    const T tiny = zero_cosine<T>();  // stands for a zero that turns up by chance
    T value = b(1), c = value, d(0);
    for (int n = 2; n < 20000; ++n) {
        d = b(n) + a(n) * d;
        d = T(1) / (equal(d, T(0)) ? tiny : d);
        c = b(n) + a(n) / c;
        c = equal(c, T(0)) ? tiny : c;
        value *= c * d;
        if (abs(c * d - T(1)) < std::numeric_limits<T>::epsilon()) break;
    }
    return a(1) / value;
}

/// The regularised incomplete beta function I_x(p, q), by the continued fraction of Didonato & Morris 1992,
/// "Algorithm 708: Significant Digit Computation of the Incomplete Beta Function Ratios",
/// and by the symmetry I_x(p, q) = 1 - I_(1-x)(q, p). (NIST DLMF 8.17.22, of which this is every second convergent,
/// loses p ULP as x nears 1.) `complement` is 1 - x; `norm` is Gamma(p + q)/(Gamma(p) Gamma(q)).
/// p, q > 0. Scalar types only. With q = 1/2 tens of terms for any p.
template <one_lane T>
constexpr T incomplete_beta(const T& p, const T& q, const T& x, const T& complement, const T& norm) {
    using std::exp, std::log, std::log1p;
    const auto tail = [&](const T& p1, const T& q1, const T& x1, const T& y1) {
        const auto numerator = [&](int n) {
            const T m = T(n - 1), odd = p1 + T(2) * m - T(1);
            return n == 1 ? T(1) : (p1 + m - T(1)) * (p1 + q1 + m - T(1)) * m * (q1 - m) * (x1 / odd) * (x1 / odd);
        };
        const auto denominator = [&](int n) {
            const T m = T(n - 1),
                    whole = (p1 + m) * (p1 * y1 - q1 * x1 + T(1) + m * (T(1) + y1)) / (p1 + T(2) * m + T(1));
            return n == 1 ? whole : whole + m + m * (q1 - m) * x1 / (p1 + T(2) * m - T(1));
        };
        // x^p (1-x)^q, each from whichever of x and 1-x is exact
        const T log_x = x1 < y1 ? log(x1) : log1p(-y1), log_y = x1 < y1 ? log1p(-x1) : log(y1);
        return exp(p1 * log_x + q1 * log_y) * norm * continued_fraction<T>(numerator, denominator);
    };
    if (equal(x, T(0))) return T(0);
    if (x < (p + T(1)) / (p + q + T(2))) return tail(p, q, x, complement);
    return T(1) - (equal(complement, T(0)) ? T(0) : tail(q, p, complement, x));
}

/// The regularised upper incomplete gamma function Q(s, x) = Gamma(s, x)/Gamma(s), s > 0, x >= 0: series of positive
/// terms of its complement below s + 1, continued fraction above (DLMF 8.7.1, 8.9.2). Scalar types only.
/// Error: 1e-14 for s <= 8.
template <one_lane T>
struct incomplete_gamma {
    T s, gamma_s;
    constexpr explicit incomplete_gamma(const T& shape) : s(shape), gamma_s() {
        using std::tgamma;
        gamma_s = tgamma(s);
    }

    /// x^s e^-x / Gamma(s)
    constexpr T front(const T& x) const {
        using std::exp, std::pow;
        return exp(-x) * pow(x, s) / gamma_s;
    }
    constexpr T lower_by_series(const T& x) const {
        T term = T(1) / s, total = term;
        for (int n = 1; n < 10000 && term > total * std::numeric_limits<T>::epsilon() / T(4); ++n)
            total += term *= x / (s + T(n));
        return front(x) * total;
    }
    constexpr T upper_by_fraction(const T& x) const {
        if (!(front(x) > T(0))) return T(0);
        const auto a = [&](int n) { return n == 1 ? T(1) : T(n - 1) * (s - T(n - 1)); };
        const auto b = [&](int n) { return x + T(2 * n - 1) - s; };
        return front(x) * continued_fraction<T>(a, b);
    }
    constexpr T upper(const T& x) const { return x < s + T(1) ? T(1) - lower_by_series(x) : upper_by_fraction(x); }
    constexpr T lower(const T& x) const { return x < s + T(1) ? lower_by_series(x) : T(1) - upper_by_fraction(x); }
};

/// The upper incomplete gamma function Gamma(s, x) for any real s and x > 0: the continued fraction from x
/// or from 1 on, and below 1 the integral of the series of e^-y, term by term, as (1 - x^q)/q = -ln x phi(q ln x),
/// which has no poles. Scalar types only. Relative error 1e-14 for |s| <= 8.
template <one_lane T>
constexpr T upper_gamma(const T& s, const T& x) {
    using std::exp, std::log, std::pow;
    const T from = larger(x, T(1));
    const auto a = [&](int n) { return n == 1 ? T(1) : T(n - 1) * (s - T(n - 1)); };
    const auto b = [&](int n) { return from + T(2 * n - 1) - s; };
    const T weight = exp(-from) * pow(from, s);
    T total = weight > T(0) ? weight * continued_fraction<T>(a, b) : T(0);
    if (x < T(1)) {
        const T L = log(x);
        T sign(1);
        for (int n = 0; n < 40; ++n, sign /= T(-n)) total += sign * -L * expm1_ratio((s + T(n)) * L);
    }
    return total;
}

/// The y >= 0 with erfc(y)/2 = p, 0 < p <= 1/2. Start: Abramowitz & Stegun 26.2.23 (4.5e-4); two steps of Halley, each
/// of which cubes the error.
/// Error: 4 ULP in double. Scalar types only.
template <one_lane T>
constexpr T inverse_half_erfc(const T& p) {
    using std::erfc, std::exp, std::log, std::sqrt;
    const T t = sqrt(T(-2) * log(p));
    T y = (t - (T(2.515517) + t * (T(0.802853) + t * T(0.010328))) /
                   (T(1) + t * (T(1.432788) + t * (T(0.189269) + t * T(0.001308))))) /
          sqrt(T(2));
    for (int i = 0; i < (beyond_double<T> ? 4 : 2); ++i) {
        const T e = (erfc(y) / T(2) - p) * sqrt(pi<T>()) * exp(y * y);
        y += e / (T(1) - y * e);
    }
    return y;
}

}  // namespace lobe::detail
