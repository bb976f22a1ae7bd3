// Directional and average albedo of any BRDF, by quadrature: how much of the light it returns.
#pragma once

#include <lobe/brdf/concepts.hpp>
#include <lobe/energy/quadrature.hpp>

#include <algorithm>
#include <cassert>
#include <vector>

namespace lobe {

namespace detail {

/// The BRDF itself, or its lobes one by one where it is a composition.
template <brdf B, class G>
constexpr void for_each_lobe(const B& b, const G& g) {
    if constexpr (requires { b.for_each_lobe(g); })
        b.for_each_lobe([&](const auto& lobe) { for_each_lobe(lobe, g); });
    else
        g(b);
}

/// The cosines v.m at which a BRDF is creased, each once.
template <brdf B>
auto creases_of(const B& b) {
    using W = wide_t<typename B::scalar>;
    std::vector<W> creases;
    for_each_crease(b, [&](const auto& c) { creases.push_back(W(c)); });
    std::sort(creases.begin(), creases.end());
    creases.erase(std::unique(creases.begin(), creases.end()), creases.end());
    return creases;
}

template <brdf B>
auto directional_albedo(const B& b, const vec3<typename B::scalar>& v, bool mirrored, const quadrature& options) {
    using T = typename B::scalar;
    using S = typename B::spectrum;
    estimate<S, T> total{S(T(0)), T(0), 0};
    for_each_lobe(b, [&](const auto& lobe) {
        const auto f_cos = [lobe, v](const vec3<T>& l) { return lobe.f_cos(v, l); };
        const auto part =
            hemisphere_integral(f_cos, v, lobe.width(), mirrored, options, creases_of(lobe), smooth(lobe));
        total = {total.value + S(part.value), total.error + part.error, total.evaluations + part.evaluations};
    });
    return total;
}

/// The view in the xz plane at the cosine mu.
template <scalar T>
vec3<T> view_at(const T& mu) {
    using std::sqrt;
    return {sqrt((T(1) - mu) * (T(1) + mu)), T(0), mu};
}

}  // namespace detail

/// E(v) = int f(v,l) cos(theta_l) dl over the hemisphere: the light reflected from v's direction, and by reciprocity
/// the radiance towards v in a white furnace. Any BRDF, isotropic or not; the lobes of a composition are integrated
/// separately, each on its own width.
/// Domain: unit v above the horizon. Scalar types only.
/// Error: estimated with the value; at least the error in 99 of 100 random cases of every model. Measured, in double,
/// alpha and mu in [0.001,1], isotropic GGX at order 16 (512 evaluations of a lobe) and 32 (2048):
///   F = 1, Schlick, dielectric from outside, metals                        2e-5  1e-7  (eta below 1.01: 2e-7)
///   dielectric from inside (cut at the critical angle: 2 to 4 times the evaluations, 16 with three wavelengths)
///                                                                          1e-5  1e-7
///   conductor of eta < 1 and k < 0.5 (cut where F bends)                   2e-5  2e-6
///   f82_tint, which has a kink where it reaches 0                          5e-4  1e-4
/// Beckmann at order 32: 2e-6. Anisotropic, widths up to 1000 apart: 5e-5 at order 32 (4096), 1e-5 at 64. With a crease
/// (Oren-Nayar and its relatives, v_cavity): 5e-4 at order 32, 1e-4 at 64, 4e-5 at 128. A BRDF in float sees l rounded,
/// which is worth 6e-8/(alpha mu).
template <brdf B>
auto directional_albedo(const B& b, const vec3<typename B::scalar>& v, const quadrature& options = {}) {
    return detail::directional_albedo(b, v, false, options);
}

/// E at the view cosine mu in (0,1], for isotropic BRDFs: half the circle is enough.
template <brdf B>
    requires(B::isotropic)
auto directional_albedo(const B& b, const typename B::scalar& mu, const quadrature& options = {}) {
    assert(mu > typename B::scalar(0) && mu <= typename B::scalar(1) &&
           "directional_albedo: the cosine must be in (0,1]");
    return detail::directional_albedo(b, detail::view_at(mu), true, options);
}

/// E_avg = 2 int_0^1 E(mu) mu dmu: the light reflected under uniform illumination. Kulla & Conty 2017. Isotropic BRDFs;
/// scalar types only. An order n costs 2 n^3 evaluations a lobe, with the two lower ones 1.6 times that; the tolerance
/// stops at 128.
/// Error: returned.
template <brdf B>
    requires(B::isotropic)
auto average_albedo(const B& b, const quadrature& options = {}) {
    using T = typename B::scalar;
    using S = typename B::spectrum;
    using W = detail::wide_t<T>;
    using WS = detail::wide_t<S>;
    assert((options.order == 0 || options.order >= 2) && "average_albedo: order must be at least 2, or 0");
    int evaluations = 0;
    const auto at_order = [&](int order) {
        const gauss_legendre<W> rule(order);
        const detail::hemisphere_rule<W> directions(order);
        WS total(W(0));
        detail::for_each_lobe(b, [&](const auto& lobe) {
            const auto creases = detail::creases_of(lobe);
            // of a smooth surface E is F, and bends at the critical cosine
            for (std::size_t k = 0; k <= creases.size(); ++k) {
                const W from = k > 0 ? creases[k - 1] : W(0), range = (k < creases.size() ? creases[k] : W(1)) - from;
                for (std::size_t i = 0; i < rule.x.size(); ++i) {
                    // towards grazing, where E bends within mu ~ alpha
                    const detail::crowded<W> node(rule.x[i], k < creases.size());
                    const W mu = from + range * node.at;
                    const vec3<T> v = detail::view_at(T(mu));
                    const auto f_cos = [lobe, v](const vec3<T>& l) { return lobe.f_cos(v, l); };
                    total = total + WS(detail::hemisphere_integral_at(f_cos, v, lobe.width(), true, directions, creases,
                                                                      &evaluations)) *
                                        (W(2) * rule.w[i] * range * node.slope * mu);
                }
            }
        });
        return total;
    };
    const auto result = detail::converge<W>(at_order, options, 128);
    const vec2<T> width = b.width();
    const W rounded = detail::rounding<T>(result.value, W(smaller(width.x, width.y)), result.order);
    return estimate<S, T>{S(result.value), T(result.error + rounded), evaluations};
}

}  // namespace lobe
