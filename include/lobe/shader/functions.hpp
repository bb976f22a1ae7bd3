// What C has and shading languages lack, from what they have.
#pragma once

#include <lobe/shader/function.hpp>

namespace lobe::shader::detail {

/// ln(1 + x): 2 atanh(x/(2 + x)) by six terms near 0, where log of GPUs is right to 2^-21 absolute.
/// Error: 4 ULP near 0.
inline auto log1p_function() {
    return function("log1p", {"x"}, [](real x) {
        const real z = x / (real(2) + x), z2 = z * z;
        const real near =
            real(2) * z *
            (real(1) + z2 * (real(1.0 / 3) +
                             z2 * (real(1.0 / 5) + z2 * (real(1.0 / 7) + z2 * (real(1.0 / 9) + z2 * real(1.0 / 11))))));
        return select(x > real(-0.3) && x < real(0.5), near, log(real(1) + x));
    });
}

/// exp(x) - 1, near 0 by eight terms of its series. Error: 4 ULP near 0.
inline auto expm1_function() {
    return function("expm1", {"x"}, [](real x) {
        real series(1);
        for (int k = 8; k > 1; --k) series = real(1) + x * (series * real(1.0 / k));
        return select(abs(x) < real(0.5), x * series, exp(x) - real(1));
    });
}

/// -m/(2 + m), m = exp(-2 |x|) - 1, near 0 by the series of m: GPUs subtract exponentials. Error: 6 ULP.
inline auto tanh_function() {
    return function("tanh_", {"x"}, [](real x) {
        const real y = real(-2) * abs(x);
        real series(1);
        for (int k = 8; k > 1; --k) series = real(1) + y * (series * real(1.0 / k));
        const real m = select(y > real(-0.5), y * series, exp(y) - real(1)), positive = -m / (real(2) + m);
        return select(x < real(0), -positive, positive);
    });
}

/// exp(-z^2) t P(t), z = |x|, t = 2/(2 + z); 2 less that for x < 0. P: Chebyshev interpolation for z to 10.2, 5.3e-8.
/// Error: relative 2e-7 (1 + z^2).
inline auto erfc_function() {
    return function("erfc", {"x"}, [](real x) {
        const real z = abs(x), t = real(2) / (real(2) + z);
        const double p[] = {0.282082159, 0.282454962,  0.24249425,  0.205189347,  -0.0326891584,
                            0.286999542, -0.495058245, 0.288369804, -0.0598427028};
        real sum(p[8]);
        for (int k = 7; k >= 0; --k) sum = real(p[k]) + t * sum;
        const real positive = exp(-z * z) * (t * sum);
        return select(x < real(0), real(2) - positive, positive);
    });
}

}  // namespace lobe::shader::detail
