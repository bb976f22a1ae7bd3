// The split-sum terms of GGX in closed form, four of them: cheaper or closer.
#pragma once

#include <lobe/energy/dfg.hpp>

#include <cmath>

namespace lobe {

// All are callables (mu, alpha) -> dfg_terms, branch-free, for any scalar type, of isotropic GGX with
// `smith_correlated` and Schlick's Fresnel. Domain: mu in [0.001,1], alpha in [0.0009,1] (roughness in [0.03,1]), where
// the errors hold. Both are absolute, the largest and the rms; albedo: of F0 scale + (1 - F0) bias, for any F0.
//
//                  E                  bias               albedo
//   tiny           2.5e-2  1.1e-2     2.8e-2  1.0e-2     2.8e-2
//   cheap          1.3e-2  5.9e-3     1.6e-2  8.3e-3     1.6e-2
//   medium         4.6e-3  2.2e-3     2.9e-3  1.6e-3     4.6e-3
//   precise        1.1e-3  5.4e-4     9.6e-4  4.5e-4     1.1e-3
// (dfg_published.hpp has those that are in use: MaterialX's is off by 1.4e-1.)
// The forms follow E where it bends: 1 - E = alpha^2 mu N/D is 0 at grazing and at alpha = 0, and there a function of
// mu/alpha, which no polynomial with a constant in its denominator can be; bias = E (1 - c)^5, c an effective cosine.

namespace detail {

/// What the fits have in common: 1 - E = N/D, bias = E (1 - c)^5 with an effective cosine c = P/Q.
template <class Fit>
struct ggx_dfg_fit {
    template <class N, class Masking>
    static constexpr bool describes = detail::is_smith_ggx<N, Masking>;

    template <scalar T>
    constexpr dfg_terms<T> average(const alpha<T>& a) const {
        return dfg_average(static_cast<const Fit&>(*this), a);
    }

protected:
    template <scalar T>
    static constexpr dfg_terms<T> terms(const T& N, const T& D, const T& P, const T& Q) {
        const T both = T(1) / (D * Q);
        const T E = T(1) - N * Q * both, w = T(1) - P * D * both, w2 = w * w;
        const T bias = E * (w2 * w2 * w);
        return {E - bias, bias};
    }
};

}  // namespace detail

/// 5 terms for E, 8 for the bias.
struct dfg_fit_tiny : detail::ggx_dfg_fit<dfg_fit_tiny> {
    template <scalar T>
    constexpr dfg_terms<T> operator()(const T& mu, const alpha<T>& width) const {
        const auto k = [](double x) { return detail::constant<T>(x); };
        const T m = mu, a = width.value(), a2 = a * a, a3 = a2 * a;
        return terms(m * a2 * (k(.8215735) + k(19.310698) * a2), m * m * m + k(21.320505) * a3 * m + k(6.7557139) * a3,
                     (k(1.0574776) * m + k(1.3323929) * a) * m + (k(3.0923212) * a + k(.037398718)) * a,
                     m + (k(5.9148107) * a + k(1.3126427)) * a + k(.0072317305));
    }
};

/// 6 terms for E, 8 for the bias.
struct dfg_fit_cheap : detail::ggx_dfg_fit<dfg_fit_cheap> {
    template <scalar T>
    constexpr dfg_terms<T> operator()(const T& mu, const alpha<T>& width) const {
        const auto k = [](double x) { return detail::constant<T>(x); };
        const T m = mu, a = width.value(), a2 = a * a, a3 = a2 * a;
        return terms(m * a2 * (k(.46572191) + k(9.9895906) * a2 + k(2.117033) * a * m * m),
                     m * m * m + k(13.935205) * a3 * m + k(2.885303) * a3,
                     (k(1.0574776) * m + k(1.3323929) * a) * m + (k(3.0923212) * a + k(.037398718)) * a,
                     m + (k(5.9148107) * a + k(1.3126427)) * a + k(.0072317305));
    }
};

/// 12 terms for E, 10 for the bias.
struct dfg_fit_medium : detail::ggx_dfg_fit<dfg_fit_medium> {
    template <scalar T>
    constexpr dfg_terms<T> operator()(const T& mu, const alpha<T>& width) const {
        using std::sqrt;
        const auto k = [](double x) { return detail::constant<T>(x); };
        const T m = mu, a = width.value(), a2 = a * a, a3 = a2 * a, a4 = a2 * a2;
        const T r = sqrt(a), r2 = a, r3 = a * r, r4 = a2, r5 = a2 * r;
        return terms(
            m * a2 *
                (((k(19.25841) * a3 + k(.27913249)) - k(4.4412456) * a4 * m) * m + k(6.3986063) * a2 + k(.77557838)),
            ((m + k(8.4086552) * a4) * m + (k(17.736061) * a2 + k(3.5498514)) * a2) * m +
                ((k(.5351705) * a2 - k(1.9557374)) * a + k(2.9557564)) * a3,
            ((k(1.007147) * m + k(3.2703702) * r2) * m + k(6.58987) * r4) * m + k(2.5871971) * r5,
            (m + (k(7.78157) * r2 + k(3.1845429)) * r2) * m +
                ((k(1.8398677) * r2 + k(3.3001425)) * r + k(.43795609)) * r3);
    }
};

/// 22 terms for E, 14 for the bias.
struct dfg_fit_precise : detail::ggx_dfg_fit<dfg_fit_precise> {
    template <scalar T>
    constexpr dfg_terms<T> operator()(const T& mu, const alpha<T>& width) const {
        using std::sqrt;
        const auto k = [](double x) { return detail::constant<T>(x); };
        const T m = mu, a = width.value(), a2 = a * a, a3 = a2 * a;
        const T r = sqrt(a), r2 = a, r3 = a * r, r4 = a2, r5 = a2 * r;
        const T n4 = ((k(-80.923561) * a + k(159.31013)) * a - k(68.580009)) * a + k(23.680496);
        const T n2 = ((k(13.252991) * a + k(47.883152)) * a + k(23.356142)) * a2 + k(3.2724929);
        const T d3 = (k(4.6752467) - a) * m + k(19.079456) * a2 + k(.16968752);
        const T d2 = (k(24.166279) * a + k(86.776672)) * a2 + k(11.586927);
        const T d1 = (k(22.483315) * a + k(10.312562)) * a + k(.39994174);
        return terms(
            m * a2 * ((n4 * a * m + n2) * m + (k(3.1924329) * a - k(.30789798)) * a + k(.1134351)),
            ((d3 * m + d2 * a2) * m + d1 * a2) * m + k(.48469669) * a3,
            ((k(.99683052) * m + ((k(-1.996815) * r + k(2.612494)) * r2 + k(1.4740415)) * r2) * m + k(4.2429142) * r4) *
                    m +
                (k(.2249494) * r + k(.43820956)) * r5,
            (m + ((k(3.574554) * r + k(2.947536)) * r + k(1.1579635)) * r2) * m +
                ((k(.71944004) * r2 + k(.67032272)) * r + k(.066908963)) * r3);
    }
};

}  // namespace lobe
