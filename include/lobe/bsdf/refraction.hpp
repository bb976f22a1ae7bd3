// One side of an interface between two transparent media: Snell's law and Fresnel's transmittance.
#pragma once

#include <lobe/fresnel/dielectric.hpp>

namespace lobe::detail {

/// What a facet makes of a ray at c = v.m: g = n cos(theta_t), 0 where all is reflected, and K = g - c, which means
/// nothing there.
template <scalar T>
struct crossing {
    T g, K;
};

/// An interface as it is met from one side: n = index beyond it over index before it.
template <scalar T>
struct dielectric_side {
    T n, excess, e;  // n, n - 1, n^2 - 1: near n = 1 the digits of the last two are not in n

    /// From above, where eta is the index below over the index above ...
    static constexpr dielectric_side above(const T& eta) {
        const T d = eta - T(1);
        return {eta, d, d * d + T(2) * d};
    }
    /// ... and from below.
    static constexpr dielectric_side below(const T& eta) {
        const dielectric_side other = above(eta);
        return {T(1) / eta, -other.excess / eta, -other.e / (eta * eta)};
    }

    /// F(v.m). Walter et al. 2007, eq. 22.
    [[gnu::always_inline]] constexpr T reflectance(const T& c) const { return dielectric_reflectance(e, c); }

    /// 1 - F without the subtraction, c and g as in `crossing`: 2 c g (1/(g+c)^2 + n^2/(n^2 c + g)^2).
    [[gnu::always_inline]] constexpr T transmittance(const T& c, const T& g) const {
        const T t = g + c, p = n * n * c + g;
        return T(2) * c * g * (T(1) / (t * t) + n * n / (p * p));
    }

    /// g^2 = n^2 - 1 + c^2, K = (n^2 - 1)/(g + c); c > 0.
    [[gnu::always_inline]] constexpr crossing<T> cross(const T& c) const {
        using std::sqrt;
        const T g2 = e + c * c;
        const auto real = g2 > T(0);
        const T g = select(real, sqrt(select(real, g2, T(1))), T(0));
        return {g, e / (g + c)};
    }

    /// The direction refracted by a facet m: l = -(v + K m)/n, unit where v and m are and K is what `cross` says.
    [[gnu::always_inline]] constexpr vec3<T> refracted(const vec3<T>& v, const vec3<T>& m, const T& K) const {
        return {-(v.x + K * m.x) / n, -(v.y + K * m.y) / n, -(v.z + K * m.z) / n};
    }

    /// `a` where the mask holds, else `b`.
    template <class Side>
    [[gnu::always_inline]] static constexpr dielectric_side choose(const Side& mask, const dielectric_side& a,
                                                                   const dielectric_side& b) {
        return {select(mask, a.n, b.n), select(mask, a.excess, b.excess), select(mask, a.e, b.e)};
    }
};

}  // namespace lobe::detail
