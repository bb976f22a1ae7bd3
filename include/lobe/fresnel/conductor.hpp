// Fresnel's equations for a conductor of complex index eta + i k, unpolarised.
#pragma once

#include <lobe/core/spectrum.hpp>
#include <lobe/numeric/gauss_legendre.hpp>

#include <cassert>

namespace lobe {

/// With c = v.h, s^2 = 1 - c^2 and (a + i b)^2 = (eta + i k)^2 - s^2, which makes a b = eta k:
///   Rs = N/(N + 4 a c),          N = (a - c)^2 + b^2            (so the denominator is (a + c)^2 + b^2)
///   Rp = Rs M/(M + 4 a c s^2),   M = (a c - s^2)^2 + b^2 c^2,   F = (Rs + Rp)/2
/// Born & Wolf, "Principles of Optics", 14.2; Lagarde 2013, "Memo on Fresnel equations". Of a^2 and b^2 the larger is
/// computed and the smaller is (eta k)^2 over it; a - c is (a^2 - c^2)/(a + c). So nothing cancels, and k = 0 is
/// `dielectric`. eta, k relative to the medium outside (under a coat of index n: eta/n, k/n); one number each, or vec3
/// for three wavelengths.
/// Domain: eta in [0.001, 1e9], k in [0, 1e9] (fourth powers have to fit;
/// a perfect mirror is `perfect_reflector`); c in [0,1].
/// Error: metals (k >= 0.5, eta in [0.3,10]) 9 ULP, weaker absorbers 12 for eta in [1,10]; 14 to 300 for eta < 1 and
/// k from 0.1 to 0.001, where the critical angle of `dielectric` shows (docs/accuracy.md).
template <class S>
class conductor {
    using T = component_t<S>;

public:
    using scalar = T;
    using spectrum = S;

    constexpr conductor(const S& index, const S& extinction) : eta(index), k(extinction) {
        [[maybe_unused]] const auto large_enough = [](const T& x) { return x >= T(1) / T(1000) && x <= T(1e9f); };
        assert(detail::every(large_enough, eta) && "conductor: eta must be in [1/1000, 1e9]");
        assert(detail::every([](const T& x) { return x >= T(0) && x <= T(1e9f); }, k) &&
               "conductor: k must be in [0, 1e9]");
    }

    // (Inlined by force: docs/design.md.)
    template <std::same_as<T> U>
    [[gnu::always_inline]] constexpr S operator()(const U& c) const {
        return detail::by_component([&](const T& n, const T& kappa) { return reflectance(n, kappa, c); }, eta, k);
    }

    /// 2 int_0^1 F(u) u du, which has no closed form, by 32 Gauss points: build once, not per pixel.
    /// Error: 16 ULP where k >= 0.5 or eta >= 1.02. Below both lies the kink of total internal reflection,
    /// which Gauss points miss by 3e-14 at k = 0.3, 3e-8 at 0.1, 3e-3 at k = 0.01, 0.02 at k = 0: there
    /// `dielectric` has the closed form.
    constexpr S average() const {
        constexpr gauss_legendre_32 rule;
        S sum(T(0));
        for (int i = 0; i < 16; ++i) {
            const T z = detail::constant<T>(rule.z[i]), low = (T(1) - z) / T(2), high = (T(1) + z) / T(2);
            sum += ((*this)(low)*low + (*this)(high)*high) * detail::constant<T>(rule.w[i]);
        }
        return sum;
    }

    /// ((eta - 1)^2 + k^2)/((eta + 1)^2 + k^2).
    constexpr S F0() const { return (*this)(T(1)); }
    constexpr S index() const { return eta; }
    constexpr S extinction() const { return k; }

    /// The cosines where F bends from near 1, each to g, for quadrature to cut there:
    /// a^2 - b^2 = 0 at c^2 = 1 - eta^2 + k^2. F's branch points lie 2 eta k off it;
    /// where they are farther than c^2 F is smooth. Scalar types only.
    template <class G>
    constexpr void for_each_crease(const G& g) const {
        detail::by_component(
            [&](const T& n, const T& kappa) {
                using std::sqrt;
                const T c2 = (T(1) - n) * (T(1) + n) + kappa * kappa;
                if (c2 < T(1) && T(2) * n * kappa < c2) g(T(sqrt(c2)));
                return c2;
            },
            eta, k);
    }

private:
    [[gnu::always_inline]] static constexpr T reflectance(const T& n, const T& kappa, const T& c) {
        using std::sqrt;
        const T d = n - T(1), e = d * d + T(2) * d, c2 = c * c, s2 = (T(1) - c) * (T(1) + c), ab = n * kappa;
        const T q = e + c2 - kappa * kappa;  // a^2 - b^2
        const T larger = (sqrt(q * q + T(4) * ab * ab) + select(q < T(0), -q, q)) / T(2);
        const T smaller = ab * ab / select(larger > T(0), larger, T(1));
        const T a2 = select(q < T(0), smaller, larger), b2 = select(q < T(0), larger, smaller);
        const T a = sqrt(a2), sum = a + c, sum2 = sum * sum, difference = e + (b2 - kappa * kappa);  // (a - c)(a + c)
        const T ac4 = T(4) * a * c, rest = a * c - s2;
        const T N = difference * difference + b2 * sum2, M = rest * rest + b2 * c2;  // N times (a + c)^2
        const T den = N + ac4 * sum2;
        const T Rs = select(den > T(0), N / select(den > T(0), den, T(1)), T(1));
        return Rs * (T(1) + M / (M + ac4 * s2)) / T(2);
    }

    S eta, k;
};

}  // namespace lobe
