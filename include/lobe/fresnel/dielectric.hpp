// Fresnel's equations between two transparent media, unpolarised, and Walsh's average.
#pragma once

#include <lobe/fresnel/ior.hpp>

namespace lobe {

namespace detail {

/// Fresnel's reflectance from e = eta^2 - 1, which is all it depends on (-> `dielectric`). (Inlined by force:
/// docs/design.md.)
template <scalar T>
[[gnu::always_inline]] constexpr T dielectric_reflectance(const T& e, const T& c) {
    using std::sqrt;
    const T c2 = c * c, s2 = (T(1) - c) * (T(1) + c);
    const T g2 = e + c2;
    const auto real = g2 > T(0);
    const T g = sqrt(select(real, g2, T(1))), gc = g * c;
    const T rs = quotient(real, e, e + T(2) * (c2 + gc));
    const T p = (gc - s2) / (gc + s2);
    return select(real, rs * rs * (T(1) + p * p) / T(2), T(1));
}

}  // namespace detail

/// With c = v.h, s^2 = 1 - c^2 and g = sqrt(eta^2 - s^2):
///   Rs = ((g - c)/(g + c))^2,  Rp = Rs ((g c - s^2)/(g c + s^2))^2,  F = (Rs + Rp)/2,  and F = 1 where g is not real.
/// Cook & Torrance 1982 and Walter et al. 2007, eq. 22, with (g - c)/(g + c) = e/(g + c)^2, e = eta^2 - 1,
/// and (g + c)^2 = e + 2 (c^2 + g c): nothing cancels near eta = 1, nor towards grazing.
/// eta: index on the far side over that on the side of v, > 1 from air into glass, < 1 from inside (total internal
/// reflection). One number or vec3 (dispersion).
/// Domain: eta > 0 whose square is finite; c in [0,1]. At c = 0 every eta reflects all, eta = 1 included.
/// Error: 12 ULP for eta in [0.3,10], more near the critical angle; 6/eta roundings below 0.3 (docs/accuracy.md).
template <class S>
class dielectric {
    using T = component_t<S>;

public:
    using scalar = T;
    using spectrum = S;

    constexpr explicit dielectric(const S& relative_index) : eta(relative_index) {
        assert(detail::every([](const T& x) { return x > T(0); }, eta) &&
               detail::every([](const T& x) { return detail::finite(T(x * x)); }, eta) &&
               "dielectric: eta must be above 0 and its square finite");
    }

    // (Inlined by force: docs/design.md.)
    template <std::same_as<T> U>
    [[gnu::always_inline]] constexpr S operator()(const U& c) const {
        return detail::by_component([&](const T& n) { return reflectance(n, c); }, eta);
    }

    /// 2 int_0^1 F(u) u du in closed form. Walsh 1926, "The reflection factor of a polished glass
    /// surface for diffused light".
    /// Error: 16 ULP for every eta, from inside 3.
    constexpr S average() const {
        return detail::by_component([](const T& n) { return average_reflectance(n); }, eta);
    }

    constexpr S F0() const { return f0_from_ior(eta); }
    constexpr S relative_index() const { return eta; }

    /// The cosine of the critical angle, sqrt(1 - eta^2), to and below which all is reflected; 0 for eta >= 1.
    constexpr S critical_cosine() const {
        return detail::by_component(
            [](const T& n) {
                using std::sqrt;
                return T(sqrt(select(n < T(1), (T(1) - n) * (T(1) + n), T(0))));
            },
            eta);
    }

    /// Those above 0, each to g: F leaves 1 there like a square root, so quadrature cuts. Scalar types only.
    template <class G>
    constexpr void for_each_crease(const G& g) const {
        detail::by_component(
            [&](const T& c) {
                if (c > T(0)) g(c);
                return c;
            },
            critical_cosine());
    }

private:
    [[gnu::always_inline]] static constexpr T reflectance(const T& n, const T& c) {
        const T d = n - T(1);
        return detail::dielectric_reflectance(T(d * d + T(2) * d), c);
    }

    /// Walsh's equation has poles at n = 1 that cancel. Written in x = |n - 1|/(n + 1) they cancel by algebra, and what
    /// is left of ln n = 2 atanh x is a(x) = (atanh x - x)/x^3 = 1/3 + x^2/5 + x^4/7 + ...:
    ///   F_avg = x/(12 (1+x^2)^3) [ Q(x) + 3 (1+x)^4 (1-x)^2 (1 + 6 x^2 + x^4) a(x) + 24 x (1+x)^2 ln x ]
    ///   Q(x) = 7 + 44 x - 24 x^3 + 6 x^4 + 36 x^5 + 16 x^6 + 8 x^7 + 3 x^8
    /// From inside, F_avg(n) = 1 - n^2 (1 - F_avg(1/n)).
    static constexpr T average_reflectance(const T& n) {
        using std::log;
        const auto inside = n < T(1);
        const T x = select(inside, T(1) - n, n - T(1)) / (n + T(1));
        const T x2 = x * x;
        T series(0);  // for x < 1/2, where a term has 2 bits
        for (int k = detail::digits<T>() / 2 + 1; k >= 0; --k)
            series = T(1) / detail::constant<T>(2 * k + 3) + x2 * series;
        const T ln = log(n);
        const auto far_from_1 = x2 > T(1) / T(4);
        const T a = select(far_from_1, quotient(far_from_1, select(inside, -ln, ln) / T(2) - x, x2 * x), series);
        const T h = T(1) + x2, up = (T(1) + x) * (T(1) + x), down = (T(1) - x) * (T(1) - x);
        const T Q = T(7) + x * (T(44) + x2 * (T(-24) + x * (T(6) + x * (T(36) + x * (T(16) + x * (T(8) + x * T(3)))))));
        const T bracket =
            Q + T(3) * up * up * down * (T(1) + x2 * (T(6) + x2)) * a + T(24) * x * up * log(select(x > T(0), x, T(1)));
        const T outside = x / (T(12) * h * h * h) * bracket;
        return select(inside, (T(1) - n) * (T(1) + n) + n * n * outside, outside);
    }

    S eta;
};

}  // namespace lobe
