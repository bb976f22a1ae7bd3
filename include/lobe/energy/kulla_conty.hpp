// Multiple scattering by a reciprocal lobe and the average Fresnel reflectance.
#pragma once

#include <lobe/energy/default_dfg.hpp>
#include <lobe/energy/multiple_scattering.hpp>

#include <cmath>

namespace lobe {

namespace detail {

/// What `kulla_conty` adds: F_ms (1 - E(mu)).
template <class S, scalar T, class Terms>
class kulla_conty_energy {
public:
    constexpr kulla_conty_energy(const S& F_average, const alpha<T>& width, const Terms& dfg)
        : a(width), terms(dfg), F_ms(later(F_average, T(1) - terms.average(a).albedo())) {}

    constexpr S operator()(const T& mu) const { return F_ms * (T(1) - terms(mu, a).albedo()); }
    constexpr S average() const {
        const T m = T(1) - terms.average(a).albedo();
        return F_ms * select(m < constant<T>(1e-6), T(0), m);  // house: part of the model
    }

private:
    /// The series that starts at the second bounce.
    static constexpr S later(const S& F, const T& m) {
        return by_component([&](const T& x) { return x * x * (T(1) - m) / (T(1) - x * m); }, F);
    }

    alpha<T> a;
    [[no_unique_address]] Terms terms;
    S F_ms;
};

template <class F, scalar T, class Terms>
struct first_bounce_of_table {
    F fresnel;
    alpha<T> a;
    [[no_unique_address]] Terms terms;

    constexpr auto operator()(const T& mu) const { return fresnel(mu) * terms(mu, a).albedo(); }
};

}  // namespace detail

/// f = F_ms (1 - E(v)) (1 - E(l))/(pi (1 - E_avg)),  F_ms = F_avg^2 E_avg/(1 - F_avg (1 - E_avg)).
/// Kulla & Conty 2017, "Revisiting Physically Based Shading at Imageworks"; F_avg squared, so that the series starts at
/// the second bounce: Hill 2018, "A Multi-Faceted Exploration". E: of the provider `dfg`, for the normals and masking
/// of the lobe. F has `average()`.
/// Reciprocal, lossless for F = 1. Error of the albedo against the random walk, GGX, mu in [0.02,1], alpha in [0.05,1]:
/// 0.048.
template <class Terms = default_dfg>
class kulla_conty {
public:
    constexpr explicit kulla_conty(const Terms& dfg = {}) : terms(dfg) {}

    template <class S, scalar T>
    constexpr auto energy(const S& F_average, const alpha<T>& a) const {
        return detail::kulla_conty_energy<S, T, Terms>(F_average, a, terms);
    }

    template <class N, class M, class F, class Sampler>
    constexpr auto operator()(const microfacet<N, M, F, Sampler>& first) const {
        static_assert(Terms::template describes<N, M>,
                      "kulla_conty{dfg}: these terms are of other normals or of another masking than the lobe. Bake "
                      "them: bake_dfg<float>(masking, {}, [](auto a) { return lobe::beckmann{a}; })");
        using std::exp;
        using T = typename N::scalar;
        using S = typename microfacet<N, M, F, Sampler>::spectrum;
        const alpha<T> a(first.normals().width().x);
        const auto e = energy(S(first.fresnel().average()), a);
        const T kappa = T(1) + detail::constant<T>(2.5) * exp(T(-7) * a.value());
        const detail::first_bounce_of_table<F, T, Terms> albedo{first.fresnel(), a, terms};
        return sum{detail::of_albedo(first, albedo), multiple_scattering_lobe<S, std::decay_t<decltype(e)>>(e, kappa)};
    }

    /// For image-based light, F Schlick's: radiance F0 scale + F90 bias, irradiance F_ms (1 - E).
    template <class F, scalar T>
    constexpr auto weights(const F& fresnel, const T& mu, const alpha<T>& a) const {
        const dfg_terms<T> t = terms(mu, a);
        const auto F0 = fresnel.F0();
        using S = std::decay_t<decltype(F0)>;
        return ibl_weights<S>{F0 * t.scale + fresnel.F90() * t.bias, energy(S(fresnel.average()), a)(mu)};
    }
    /// ... over a diffuse base of that albedo.
    template <class F, scalar T, class S>
    constexpr ibl_weights<S> weights(const F& fresnel, const T& mu, const alpha<T>& a, const S& albedo) const {
        return detail::over_a_base(weights(fresnel, mu, a), albedo);
    }

private:
    [[no_unique_address]] Terms terms;
};

}  // namespace lobe
