// GTR, the generalised Trowbridge-Reitz distribution; Berry's is gamma = 1.
#pragma once

#include <lobe/ndf/radial.hpp>
#include <lobe/numeric/special_functions.hpp>

#include <cassert>

namespace lobe {

/// GTR, its slopes divided by alpha. With L = ln alpha^2, t = alpha^2
/// cos^2 + sin^2 = alpha^2 (1 + tau)/(1 + alpha^2 tau) and phi(x) = (e^x - 1)/x, which is 1 at 0,
/// nothing is special at gamma = 1 or alpha = 1.
template <scalar T>
class gtr_shape {
public:
    constexpr gtr_shape(const T& width, const T& exponent) : a(width), a2(width * width), gamma(exponent), L(), norm() {
        using std::log;
        assert(all(a > T(0)) && all(a <= T(1)) && "gtr: alpha must be in (0,1]");
        assert(all(gamma > T(0)) && "gtr: gamma must be above 0");
        L = T(2) * log(a);
        norm = detail::expm1_ratio(L) / detail::expm1_ratio((gamma - T(1)) * L) * inv_pi<T>();
    }

    /// norm ((1 + tau)/(1 + alpha^2 tau))^(2 - gamma) (sec2/(1 + tau))^2.
    constexpr T D(const T& tau, const T& sec2) const {
        using std::pow;
        const T ratio = sec2 / (T(1) + tau);
        return norm * ratio * ratio * pow((T(1) + tau) / (T(1) + a2 * tau), T(2) - gamma);
    }

    /// With z = (1 - alpha^2)/(alpha^2 (1 + tau)), v = ln(1 + z) = ln(t at the horizon / t): v
    /// phi((gamma-1) v) / (-L phi((1-gamma) L)).
    constexpr T survival(const T& tau) const {
        using std::log1p;
        const T z0 = (T(1) - a) * (T(1) + a) / a2, z = z0 / (T(1) + tau), v = log1p(z);
        return detail::log1p_ratio(z) / detail::log1p_ratio(z0) / (T(1) + tau) *
               detail::expm1_ratio((gamma - T(1)) * v) / detail::expm1_ratio((T(1) - gamma) * L);
    }

    /// Inverse CDF (Burley 2012, appendix B): with y = ln(t/alpha^2)/ln(1/alpha^2), each of y and 1 - y
    /// from u without cancellation.
    constexpr T tan2(const T& u) const {
        const T x = (gamma - T(1)) * L;
        const T grow = detail::expm1_ratio(x), fall = detail::expm1_ratio(-x);
        const T y = u * grow * detail::log1p_ratio(u * x * grow);
        const T rest = (T(1) - u) * fall * detail::log1p_ratio(-(T(1) - u) * x * fall);
        return y * detail::expm1_ratio(-L * y) / (rest * detail::expm1_ratio(L * rest));  // infinite at u = 1 alone
    }

    template <scalar U>
    constexpr gtr_shape<U> as() const {
        return gtr_shape<U>(U(a), U(gamma));
    }

private:
    T a, a2, gamma, L, norm;
};

/// GTR: D = C (alpha^2 cos^2 + sin^2)^-gamma, C = phi(L) / (pi phi((1-gamma) L)). Burley 2012, "Physically-Based
/// Shading at Disney", appendix B. gamma = 2 is GGX; gamma = 1, the clear coat, is Berry 1923. Not shape-invariant but
/// for gamma = 2: only `alpha`.
/// Domain: 0 < alpha <= 1, gamma > 0 with (gamma - 1) ln(1/alpha^2) < 87 in float. D in 1/sr. No closed projected area:
/// `tabulated` or, as Burley's coat has it, `masked_by{gtr{a, 1.0f}, ggx{alpha{0.25f}}}`.
/// Error of D: 12 (1 + |ln(D pi alpha^2 cos^4)|) ULP for gamma <= 5; of the projected area:
/// 3e-6 of that along the horizon from alpha 1e-3 on; for gamma < 2, whose tail goes on from tan = alpha to tan = 1,
/// 4e-5 at alpha = 1e-4, 6e-4 at 1e-5.
template <scalar T, detail::one_width_of<T> Width = alpha<T>>
class gtr : public radial<gtr_shape<T>, Width> {
public:
    constexpr gtr(const Width& width, const T& gamma)
        : radial<gtr_shape<T>, Width>(gtr_shape<T>(width.x(), gamma), width) {}
};
template <class W, class P>
gtr(W, P) -> gtr<detail::number_t<W, P>, detail::one_width_t<W, P>>;

}  // namespace lobe
