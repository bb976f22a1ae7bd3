// Student's t-distribution of slopes, from GGX at gamma = 2 to Beckmann at infinity, and Hyper-Cauchy, its other name.
#pragma once

#include <lobe/ndf/radial.hpp>
#include <lobe/numeric/special_functions.hpp>

#include <cassert>

namespace lobe {

/// Student-t at alpha = 1: slopes with the density (1 + tau/k)^-(k+1) / pi, k = gamma - 1.
template <scalar T>
class student_t_shape {
public:
    constexpr explicit student_t_shape(const T& gamma) : student_t_shape(gamma - T(1), 0) {
        assert(all(gamma > T(3) / T(2)) && "student_t: gamma must be above 3/2, or there is no projected area");
    }

    /// k = gamma - 1, where k is what is known exactly. Precondition: k > 1/2.
    static constexpr student_t_shape from_k(const T& k) {
        assert(all(k > T(1) / T(2)) && "student_t: gamma must be above 3/2, or there is no projected area");
        return student_t_shape(k, 0);
    }

    /// (sec2/(1 + tau/k))^2 (1 + tau/k)^-(k-1) / pi. At the horizon, where for k near 1 it falls to zero
    /// too late, zero for k > 1.
    constexpr T D(const T& tau, const T& sec2) const {
        using std::exp, std::log1p;
        const T x = tau / k, ratio = sec2 / (T(1) + x);
        const T above = ratio * ratio * exp((T(1) - k) * log1p(x)) * inv_pi<T>();
        const T flat = detail::zero_cosine<T>() * T(2);
        return select(sec2 * flat * flat < T(1), above, select(k > T(1), T(0), above));
    }

    constexpr T survival(const T& tau) const {
        using std::exp, std::log1p;
        return exp(-k * log1p(tau / k));
    }
    constexpr T tan2(const T& u) const {
        using std::expm1, std::log1p;
        return k * expm1(-log1p(-u) / k);
    }

    /// Closed (Ribardiere et al. 2017): with y = k/(k + a^2),
    ///   B y^(k-1/2) - a Q,  Q = I_y(k, 1/2)/2,  B = k^(3/2) Gamma(k + 1/2) / (sqrt(pi) Gamma(k + 1) (2k - 1)),
    /// whose difference costs a factor of 1 + min(k, a^2): computed in double at least. Scalar types only.
    constexpr T back(const T& a) const requires(detail::one_lane<T>) {
        using W = detail::at_least_double<T>;
        using std::exp, std::log1p, std::sqrt;
        if constexpr (!std::same_as<W, T>) {
            return T(as<W>().back(W(a)));
        } else {
            const T a2 = a * a, x = a2 / k, y = T(1) / (T(1) + x);
            const T complement = x < T(1) ? x / (T(1) + x) : T(1) - y;
            const T ratio = gamma_ratio() / sqrt(pi<T>());
            const T Q = detail::incomplete_beta(k, T(1) / T(2), y, complement, ratio) / T(2);
            const T B = sqrt(k) * ratio / (T(2) * k - T(1));
            return larger(B * exp((T(1) / T(2) - k) * log1p(x)) - (Q > T(0) ? a * Q : T(0)), T(0));
        }
    }

    template <scalar U>
    constexpr student_t_shape<U> as() const {
        return student_t_shape<U>::from_k(U(k));
    }

private:
    constexpr student_t_shape(const T& exponent, int) : k(exponent) {}

    /// Gamma(k + 1/2)/Gamma(k) by its asymptotic series in w^-2, w = k - 1/4 (NIST DLMF 5.11.14), after the recurrence
    /// has raised k to 16. Relative error 5e-19. (Beyond double: Gamma itself.)
    constexpr T gamma_ratio() const {
        using std::sqrt, std::tgamma;
        if constexpr (detail::beyond_double<T>)
            if (k < T(10000)) return tgamma(k + T(1) / T(2)) / tgamma(k);
        T raised = k, over(1), under(1);
        for (; raised < T(16); raised += T(1)) over *= raised, under *= raised + T(1) / T(2);
        const T w = raised - T(1) / T(4), i = T(1) / (w * w);
        const double above[] = {1, -19, 631, -174317, 20491783, -7334801895},
                     below[] = {0x1p6, 0x1p13, 0x1p19, 0x1p27, 0x1p33, 0x1p40};
        T series(0);
        for (int n = 5; n >= 0; --n) series = i * (T(above[n]) / T(below[n]) + series);
        return over / under * sqrt(w) * (T(1) + series);
    }

    T k;
};

/// STD: D = (gamma-1)^gamma alpha^(2 gamma - 2) / (pi cos^4 ((gamma-1) alpha^2 + tan^2)^gamma), isotropic from `alpha`,
/// anisotropic from `alpha_xy`. Ribardiere, Bringier, Meneveaux & Simonot 2017, "STD: Student's t-Distribution of
/// Slopes for Microfacet Based BSDFs". gamma = 2 is GGX, gamma to infinity Beckmann; smaller gamma has longer tails.
/// Domain: alpha as `beckmann`, gamma > 3/2 (below, the projected area is infinite). D in 1/sr. Projected area, Lambda
/// and visible normals: scalar types only (0.1 to 0.3 microseconds; a normal 0.3 seen from above, 1 to 4 at 60 degrees,
/// 10 to 17 at grazing ones).
/// Error of D: 10 (1 + |ln(D pi ax ay cos^4)|) ULP; relative, of the projected area 1e-14, in float 3e-7; of Lambda,
/// where it is above 1e-12, 1e-12, in float, above 1e-4, 2e-6.
template <scalar T, detail::width_of<T> Width = alpha<T>>
class student_t : public radial<student_t_shape<T>, Width> {
public:
    constexpr student_t(const Width& width, const T& gamma)
        : radial<student_t_shape<T>, Width>(student_t_shape<T>(gamma), width) {}
};
template <class W, class P>
student_t(W, P) -> student_t<detail::number_t<W, P>, detail::width_t<W, P>>;

namespace detail {

template <scalar T>
constexpr alpha<T> narrower(const alpha<T>& width, const T& by) {
    return alpha<T>(width.x() / by);
}
template <scalar T>
constexpr alpha_xy<T> narrower(const alpha_xy<T>& width, const T& by) {
    return {width.x() / by, width.y() / by};
}

}  // namespace detail

/// Hyper-Cauchy: D = (gamma-1) / (pi alpha^2 cos^4) (1 + tan^2/alpha^2)^-gamma.
/// Wellems et al. 2006; Hoffman 2016, "Recent Advances in Physically Based Shading".
/// It is Student-t of the width alpha/sqrt(gamma - 1), which `width()` returns.
/// Domain and error: those of `student_t`.
template <scalar T, detail::width_of<T> Width = alpha<T>>
class hyper_cauchy : public student_t<T, Width> {
public:
    constexpr hyper_cauchy(const Width& width, const T& gamma)
        : student_t<T, Width>(detail::narrower(width, root(gamma - T(1))), gamma) {}

private:
    static constexpr T root(const T& k) {
        using std::sqrt;
        assert(all(k > T(1) / T(2)) && "hyper_cauchy: gamma must be above 3/2, or there is no projected area");
        return sqrt(k);
    }
};
template <class W, class P>
hyper_cauchy(W, P) -> hyper_cauchy<detail::number_t<W, P>, detail::width_t<W, P>>;

}  // namespace lobe
