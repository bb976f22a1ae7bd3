// Gamma(2 + a) Gamma(2 + b) / Gamma(2 + a + b): what correlation takes from a product of two masking functions.
#pragma once

#include <lobe/core/spectrum.hpp>
#include <lobe/numeric/precision.hpp>

namespace lobe::detail {

/// rho(a, b) = Gamma(2 + a) Gamma(2 + b) / Gamma(2 + a + b) = (1 + a) (1 + b) B(1 + a, 1 + b), in (0,1]; a, b >= 0.
/// With p = 14 + a and r = 14 + b, B(p, r) by Stirling's series and twelve steps of the recurrence down to 2.
/// Relative error: 1e-13, beyond double by `lgamma`. Above 1e20 both count as 1e20.
/// Scalar types only.
template <one_lane T>
constexpr T beta_ratio(const T& a, const T& b) {
    using std::exp, std::lgamma, std::log1p, std::sqrt;
    if constexpr (beyond_double<T>) {
        return exp(T(lgamma(T(2) + a)) + T(lgamma(T(2) + b)) - T(lgamma(T(2) + a + b)));
    } else {
        using W = at_least_double<T>;
        constexpr int steps = 12;
        const W x = W(smaller(smaller(a, b), T(1e20))), y = W(smaller(larger(a, b), T(1e20)));
        const W p = W(steps + 2) + x, r = W(steps + 2) + y, s = x + y;
        const auto stirling = [](const W& z) {  // ln Gamma(z) - (z - 1/2) ln z + z - ln(2 pi)/2
            const W v = W(1) / (z * z);
            return (W(1) / W(12) - v * (W(1) / W(360) - v * (W(1) / W(1260) - v * (W(1) / W(1680) - v / W(1188))))) / z;
        };
        W ratio = (W(2 * steps + 2) + s) * (W(2 * steps + 3) + s);
        for (int k = 0; k < steps; ++k)
            ratio *= ((W(2 * k + 2) + s) / (W(k + 2) + x)) * ((W(2 * k + 3) + s) / (W(k + 2) + y));
        return T(sqrt(W(2) * pi<W>() * (W(1) / p + W(1) / r)) *
                 exp(stirling(p) + stirling(r) - stirling(p + r) - p * log1p(r / p) - r * log1p(p / r)) * ratio);
    }
}

/// The same without a branch or a call: for the smaller of a and b, x, and the larger, y,
///   rho = Gamma(2 + x) (2 + x + y)/(2 + y) Gamma(w + (1 - x)/2) / Gamma(w + (1 + x)/2),  w = y + (5 + x)/2,
/// the last quotient as w^-x exp(-S), S from Stirling's series about w; rational functions for ln Gamma(2 + x)/x, for
/// the logarithm of the 16th root of w, which is near 1, and for the exponential function of a 16th.
/// (Inlined by force: docs/design.md.)
/// Error: absolute 1.3e-6 in float, 2.1e-7 in wider types. x above 16, where rho is below 1e-8, counts as 16, y above
/// 2^40 as 2^40; rho is 1e-35 at least.
template <scalar T>
[[gnu::always_inline]] constexpr T beta_ratio_fit(const T& a, const T& b) {
    using std::sqrt;
    const auto c = [](double value) { return constant<T>(value); };
    const T x = smaller(smaller(a, b), T(16)), y = smaller(larger(a, b), c(0x1p40));
    const T h = x / T(2), w = y + h + T(5) / T(2), t = h / w, t2 = t * t;

    const T root = sqrt(sqrt(sqrt(sqrt(w))));
    const T log_w =
        T(16) * (root - T(1)) *
        (c(3.39897009686) + root * (c(9.58674572781) + root * (c(3.50208828207) + root * c(0.163507898388)))) /
        (T(1) +
         root * (c(7.25640041893) + root * (c(7.06640244848) + root * (c(1.29660374498) + root * c(0.0319283665789)))));
    const T log_gamma =
        (c(0.42278445463) +
         x * (c(0.609027425381) + x * (c(0.203805963395) + x * (c(0.0175991030411) + x * c(0.000261242480047))))) /
        (T(1) +
         x * (c(0.677802819049) + x * (c(0.124337590912) + x * (c(0.00619572170228) + x * c(5.06188884437e-5)))));
    // z ln z - z + ln(2 pi)/2 - ln Gamma(z + 1/2), at w - h and w + h
    const auto rest = [&](const T& z) {
        const T v = T(1) / (z * z);
        return (c(0.0416666143059) - v * (c(0.0024243059182) - v * c(0.000655578817445))) / z;
    };
    // ((1+t) ln(1+t) - (1-t) ln(1-t) - 2t) w, beside x ln w
    const T bend =
        x * t2 * (c(0.166666653389) + t2 * (c(0.0500037470892) + t2 * (c(0.0236449485094) + t2 * c(0.0161629383968))));
    const T exponent = smaller(x * (log_w - log_gamma) - bend + rest(w - h) - rest(w + h), T(80));

    // e^-exponent: e^-q - 1 for a 16th, squared twice as that, where it is small, and twice as it is
    const T q = exponent / T(16);
    const T minus =
        -q *
        (c(0.999999993067) +
         q * (c(0.00878295581728) + q * (c(0.0260220200362) + q * (c(6.22000116841e-5) + q * c(2.14288859897e-5))))) /
        (T(1) +
         q * (c(0.508782659584) + q * (c(0.113748779652) + q * (c(0.0138003064805) + q * c(0.000837898887038)))));
    const T eighth = minus * (T(2) + minus), quarter = T(1) + eighth * (T(2) + eighth), half = quarter * quarter;
    return smaller(half * half * ((T(2) + x + y) / (T(2) + y)), T(1));
}

}  // namespace lobe::detail
