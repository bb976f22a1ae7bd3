// Phong's lobe around the mirror direction, as a distribution of normals.
#pragma once

#include <lobe/ndf/radial.hpp>
#include <lobe/width/exponents.hpp>

#include <cassert>

namespace lobe {

/// Phong's lobe, its slopes divided by alpha. t = alpha^2 tau is tan(theta)^2, and cos(2 theta) = (1 - t)/(1 + t).
template <scalar T>
class phong_shape {
public:
    constexpr explicit phong_shape(const T& width) : a2(width * width) {
        assert(all(a2 > T(0)));
        assert(all(a2 <= T(1)));
    }

    /// (1 + alpha^2)/pi cos(2 theta)^n (sec2/(1 + t))^2.
    constexpr T D(const T& tau, const T& sec2) const {
        using std::exp, std::log1p;
        const T t = a2 * tau, ratio = sec2 / (T(1) + t), inside = select(t < T(1), t, T(0));
        const T n = (T(1) - a2) / (T(2) * a2), peak = (T(1) + a2) * inv_pi<T>();
        return select(t < T(1), peak * ratio * ratio * exp(n * (log1p(-inside) - log1p(inside))), T(0));
    }

    /// cos(2 theta)^(n + 1), n + 1 = (1 + alpha^2)/(2 alpha^2).
    constexpr T survival(const T& tau) const {
        using std::exp, std::log1p;
        const T t = smaller(a2 * tau, T(1));
        return exp((log1p(-t) - log1p(t)) * ((T(1) + a2) / (T(2) * a2)));
    }
    constexpr T tan2(const T& u) const {
        using std::log1p, std::tanh;
        return tanh(-log1p(-u) * (a2 / (T(1) + a2))) / a2;
    }
    /// 45 degrees, or where less than 1e-26 is steeper.
    constexpr T max_tan2() const {
        using std::tanh;
        return tanh(T(60) * (a2 / (T(1) + a2))) / a2;
    }

    template <scalar U>
    constexpr phong_shape<U> as() const {
        phong_shape<U> same(U(1) / U(2));
        same.a2 = U(a2);
        return same;
    }

private:
    template <scalar>
    friend class phong_shape;

    T a2;
};

/// Phong: D = 2 (n + 1)/pi max(0, cos 2 theta_m)^n, n = (1/alpha^2 - 1)/2, so 2 (n + 1) = (1 + alpha^2)/alpha^2: seen
/// from the normal, the mirror of such facets is Phong's own lobe (r.v)^n, r.v = cos 2 theta_m. Phong 1975,
/// "Illumination for Computer Generated Pictures", gave the lobe and no surface; this is the one that has it,
/// normalised. Its facets are tilted by less than 45 degrees, at alpha = 1 evenly up to there. Practice pairs it with
/// another's masking: `masked_by{phong{a}, ggx{a}}`. Not shape-invariant: only `alpha`.
/// Domain: 0 < alpha <= 1 (n >= 0). D in 1/sr. No closed projected area: `tabulated` or `masked_by`.
/// Error of D: 10 (1 + |ln(D pi alpha^2)|) / cos(2 theta_m) ULP; of the projected area: 3e-5 of that along the horizon.
template <scalar T, detail::one_width_of<T> Width = alpha<T>>
class phong : public radial<phong_shape<T>, Width> {
public:
    constexpr explicit phong(const Width& width) : radial<phong_shape<T>, Width>(phong_shape<T>(width.x()), width) {}
    static constexpr phong from_exponent(const T& n) { return phong(alpha_from_phong_exponent(n)); }
};
template <class W>
phong(W) -> phong<detail::number_t<W>, detail::one_width_t<W>>;

}  // namespace lobe
