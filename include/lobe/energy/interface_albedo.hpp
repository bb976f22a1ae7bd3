// How much light a rough interface reflects and transmits, by quadrature.
#pragma once

#include <lobe/bsdf/concepts.hpp>
#include <lobe/energy/albedo.hpp>
#include <lobe/energy/refraction_quadrature.hpp>

namespace lobe {

/// A BSDF of one number whose refraction follows one index: `rough_dielectric`.
template <class B>
concept refracting_bsdf = bsdf<B> && requires(const B b) {
    { b.relative_index() } -> std::same_as<typename B::scalar>;
    { b.width() } -> std::same_as<vec2<typename B::scalar>>;
    { B::isotropic } -> std::convertible_to<bool>;
};

/// int f |cos(theta_l)| dl over v's side and over the other, each with an estimate of its error. For importance
/// transport the shares of the light that arrives along v; for radiance the transmitted part is that over
/// (eta_l/eta_v)^2.
template <scalar T>
struct interface_albedo {
    estimate<T, T> reflected, transmitted;
};

namespace detail {

/// The side that v is on, and what the integrals ask of the BSDF there, as if that were above.
template <refracting_bsdf B>
struct faced {
    using T = typename B::scalar;
    using W = wide_t<T>;
    const B& b;
    bool below;
    dielectric_side<W> side;
    std::vector<W> creases;

    faced(const B& bsdf, bool from_below)
        : b(bsdf), below(from_below), side(from_below ? dielectric_side<W>::below(W(b.relative_index()))
                                                      : dielectric_side<W>::above(W(b.relative_index()))) {
        using std::sqrt;
        if (side.e < W(0)) creases.push_back(sqrt(-side.e));
    }
    auto f_cos(const vec3<T>& v) const {
        return [this, seen = turned(v)](const vec3<T>& l) { return b.f_cos(seen, turned(l)); };
    }

private:
    vec3<T> turned(const vec3<T>& w) const { return {w.x, w.y, below ? -w.z : w.z}; }
};

template <refracting_bsdf B>
interface_albedo<typename B::scalar> albedo_of(const B& b, const vec3<typename B::scalar>& v, bool mirrored,
                                               const quadrature& options) {
    using T = typename B::scalar;
    using W = wide_t<T>;
    const faced<B> side(b, v.z < T(0));
    const vec3<T> up{v.x, v.y, absolute(v.z)};
    const auto f_cos = side.f_cos(up);
    int evaluations = 0;
    const auto refracted = converge<W>(
        [&](int order) {
            return refraction_integral_at<T>(f_cos, up, side.side, b.width(), mirrored, order, &evaluations);
        },
        options, 192);
    const W width = W(smaller(b.width().x, b.width().y));
    return {hemisphere_integral(f_cos, up, b.width(), mirrored, options, side.creases),
            {T(refracted.value), T(refracted.error + rounding<T>(refracted.value, width * W(up.z), refracted.order)),
             evaluations}};
}

}  // namespace detail

/// Of a view anywhere but on the horizon. Scalar types only.
/// Error: estimated with the values. Measured, in double, GGX, alpha in [0.01,1], cosines from 0.02, eta 1.1 to 2.4 and
/// inverse: 1e-7 for each at order 32.
template <refracting_bsdf B>
auto directional_albedo(const B& b, const vec3<typename B::scalar>& v, const quadrature& options = {}) {
    return detail::albedo_of(b, v, false, options);
}

/// At the cosine mu, in (0,1] from above and in [-1,0) from below, for isotropic BSDFs: half the circle is enough.
template <refracting_bsdf B>
    requires(B::isotropic)
auto directional_albedo(const B& b, const typename B::scalar& mu, const quadrature& options = {}) {
    using T [[maybe_unused]] = typename B::scalar;  // in the assert alone
    assert(mu >= T(-1) && mu <= T(1) && absolute(mu) > T(0) &&
           "directional_albedo: the cosine must be in [-1,1], not 0");
    return detail::albedo_of(b, detail::view_at(mu), true, options);
}

/// 2 int_0^1 E(mu) mu dmu of both, under uniform illumination from above or from below. Isotropic BSDFs.
/// Cut where a smooth interface begins to reflect all, and where the facets that do reach the horizon, mu = n.
template <refracting_bsdf B>
    requires(B::isotropic)
auto average_albedo(const B& b, bool from_below, const quadrature& options = {}) {
    using T = typename B::scalar;
    using W = detail::wide_t<T>;
    const detail::faced<B> side(b, from_below);
    int evaluations[2] = {0, 0};
    const auto at_order = [&](int order) {
        const gauss_legendre<W> rule(order);
        const detail::hemisphere_rule<W> directions(order);
        std::vector<W> ends = side.creases;
        if (!ends.empty()) ends.push_back(side.side.n);
        std::sort(ends.begin(), ends.end());
        ends.push_back(W(1));
        vec2<W> total(W(0));
        W from(0);
        for (std::size_t k = 0; k < ends.size(); ++k) {
            const W range = ends[k] - from;
            for (std::size_t i = 0; i < rule.x.size(); ++i) {
                const detail::crowded<W> node(rule.x[i], k + 1 < ends.size());
                const W mu = from + range * node.at;
                const vec3<T> v = detail::view_at(T(mu));
                const auto f_cos = side.f_cos(v);
                total += vec2<W>(detail::hemisphere_integral_at(f_cos, v, b.width(), true, directions, side.creases,
                                                                &evaluations[0]),
                                 detail::refraction_integral_at<T>(f_cos, v, side.side, b.width(), true, directions,
                                                                   &evaluations[1])) *
                         (W(2) * rule.w[i] * range * node.slope * mu);
            }
            from = ends[k];
        }
        return total;
    };
    const auto result = detail::converge<W>(at_order, options, 128);
    const W width = W(smaller(b.width().x, b.width().y));
    const auto part = [&](const W& value, int count) {
        return estimate<T, T>{T(value), T(result.error + detail::rounding<T>(value, width, result.order)), count};
    };
    return interface_albedo<T>{part(result.value.x, evaluations[0]), part(result.value.y, evaluations[1])};
}

}  // namespace lobe
