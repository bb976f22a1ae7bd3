// Split-sum fits that are in use elsewhere, for comparison and for matching a renderer.
#pragma once

#include <lobe/energy/dfg_fit.hpp>

namespace lobe {

// Callables (mu, alpha) -> dfg_terms as in dfg_fit.hpp, of the same terms. Errors against `dfg_exact` over mu in
// [0.001,1], roughness in [0.03,1], absolute: the largest and the rms.
//
//                      E                  bias               scale
//   dfg_karis_mobile   5.4e-1  2.1e-1     8.5e-2  3.9e-2     4.9e-1
//   dfg_lazarov        4.4e-1  1.1e-1     4.9e-1  1.4e-1     5.1e-1
//   dfg_hirvonen       4.0e-1  1.2e-1     9.4e-2  2.1e-2     3.6e-1
//   dfg_materialx      1.4e-1  2.6e-2     4.8e-2  8.0e-3     1.1e-1

/// Karis 2014, "Physically Based Shading on Mobile". Of the masking of Unreal Engine 4, k = (r + 1)^2/8.
struct dfg_karis_mobile : detail::ggx_dfg_fit<dfg_karis_mobile> {
    template <scalar T>
    constexpr dfg_terms<T> operator()(const T& mu, const alpha<T>& width) const {
        using std::exp, std::sqrt;
        const auto k = [](double x) { return detail::constant<T>(x); };
        const T r = sqrt(width.value()), smooth = T(1) - r;
        const T falloff = exp(k(-9.28 * 0.693147180559945309) * mu);
        const T a004 = smaller(smooth * smooth, falloff) * smooth + k(.0425) - k(.0275) * r;
        return {k(1.04) - k(.572) * r - k(1.04) * a004, k(1.04) * a004 + k(.022) * r - k(.04)};
    }
};

/// Lazarov 2013, "Getting More Physical in Call of Duty: Black Ops II", with gloss = 1 - roughness.
struct dfg_lazarov : detail::ggx_dfg_fit<dfg_lazarov> {
    template <scalar T>
    constexpr dfg_terms<T> operator()(const T& mu, const alpha<T>& width) const {
        using std::exp, std::sqrt;
        const auto k = [](double x) { return detail::constant<T>(x); };
        const T g = T(1) - sqrt(width.value());
        const T falloff = exp(k(-9.28 * 0.693147180559945309) * mu);
        const T bias = k(1 / .96) * g * smaller(k(.475) * g, falloff) + k((.0275 - .25 * .04) / .96) * g +
                       k((.015 - .75 * .04) / .96);
        return {k(.25) * g + k(.75) - bias, bias};
    }
};

/// Hirvonen, Seppala, Aizenshtein & Smal 2019, "Accurate Real-Time Specular Reflections with Radiance Caching" (Ray
/// Tracing Gems, chapter 32), eq. 4: ratios of polynomials in mu and alpha.
struct dfg_hirvonen : detail::ggx_dfg_fit<dfg_hirvonen> {
    template <scalar T>
    constexpr dfg_terms<T> operator()(const T& mu, const alpha<T>& width) const {
        const auto k = [](double x) { return detail::constant<T>(x); };
        const T m = mu, m2 = m * m, m3 = m2 * m, a = width.value(), a3 = a * a * a;
        const T bias =
            ((k(.99044) - k(1.28514) * m) + (k(1.29678) - k(.755907) * m) * a) /
            ((T(1) + k(2.92338) * m + k(59.4188) * m3) + (k(20.3225) - k(27.0302) * m + k(222.592) * m3) * a +
             (k(121.563) + k(626.13) * m + k(316.627) * m3) * a3);
        const T scale =
            ((k(.0365463) + k(3.32707) * m) + (k(9.0632) - k(9.04756) * m) * a) /
            ((T(1) + k(3.59685) * m2 - k(1.36772) * m3) + (k(9.04401) - k(16.3174) * m2 + k(9.22949) * m3) * a +
             (k(5.56589) + k(19.7886) * m2 - k(20.2123) * m3) * a3);
        return {scale, bias};
    }
};

/// The rational fit of MaterialX 1.38 (mx_ggx_dir_albedo_analytic), clamped to [0,1] as it is there.
struct dfg_materialx : detail::ggx_dfg_fit<dfg_materialx> {
    template <scalar T>
    constexpr dfg_terms<T> operator()(const T& mu, const alpha<T>& width) const {
        const T x = mu, y = width.value();
        const auto p = [&](double one, double x1, double y1, double xy, double x2, double y2, double x2y, double xy2,
                           double x2y2) {
            const auto k = [](double c) { return detail::constant<T>(c); };
            return k(one) + k(x1) * x + k(y1) * y + k(xy) * x * y + k(x2) * x * x + k(y2) * y * y + k(x2y) * x * x * y +
                   k(xy2) * x * y * y + k(x2y2) * x * x * y * y;
        };
        const auto clamped = [](const T& t) { return smaller(larger(t, T(0)), T(1)); };
        return {clamped(p(.1003, -.6303, 9.748, -2.038, 29.34, -8.245, -26.44, 19.99, -5.448) /
                        p(1, -1.765, 8.263, 11.53, 28.96, -7.507, -36.11, 15.86, 33.37)),
                clamped(p(.9345, -2.323, 2.229, -3.748, 1.424, -.7684, 1.436, .2913, .6286) /
                        p(1, .2281, 15.94, -55.83, 13.08, 41.26, 54.9, 300.2, -285.1))};
    }
};

/// 1 - E and its average in the notes of Kulla & Conty 2017, "Revisiting Physically Based Shading at Imageworks",
/// appendix: what the facets lose after one bounce, of GGX with `smith_correlated`. They know no bias, so they are no
/// provider of split-sum terms. Error of E: 0.103, rms
/// 0.012; of its average: 0.0012.
struct kulla_conty_fit {
    template <scalar T>
    constexpr T lost(const T& mu, const alpha<T>& width) const {
        using std::sqrt;
        const auto k = [](double x) { return detail::constant<T>(x); };
        const T r = sqrt(width.value()), c = sqrt(mu);
        const T s = k(-.170718) * c + (k(4.07985) + (k(-11.5295) + (k(18.4961) - k(9.23618) * r) * r) * r) * r;
        const T t = k(.0632331) * mu + (k(3.1434) + (k(-7.47567) + (k(13.0482) - k(7.0401) * r) * r) * r) * r;
        const T s2 = s * s, t2 = t * t;
        return s2 * s2 * s2 * (c * sqrt(c)) / (t2 * t2 * t2 + mu * mu);
    }
    template <scalar T>
    constexpr T lost_on_average(const alpha<T>& width) const {
        using std::sqrt;
        const auto k = [](double x) { return detail::constant<T>(x); };
        const T r = sqrt(width.value());
        return k(.592665) * r * r * r / (T(1) - k(1.47034) * r + k(1.47196) * r * r);
    }
};

}  // namespace lobe
