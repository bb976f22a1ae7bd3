// The multiple scattering of GGX in closed form: as bright, and as coloured, as the random walk.
#pragma once

#include <lobe/energy/default_dfg.hpp>
#include <lobe/energy/multiple_scattering.hpp>
#include <lobe/fresnel/schlick.hpp>

#include <cmath>

namespace lobe {

namespace detail {

template <class F>
concept knows_both_ends = requires(const F fresnel) {
    fresnel.F0();
    fresnel.F90();
};

/// A Fresnel reflectance as F0 + (F90 - F0) (1 - u)^5 - dip u (1 - u)^6: right at 0, 82 and 90 degrees.
template <class F, scalar T>
class fresnel_ends {
public:
    using S = std::decay_t<std::invoke_result_t<const F&, const T&>>;
    static constexpr bool dips = true;

    // at u = 1/7: (6/7)^5, and the largest of u (1 - u)^6
    constexpr explicit fresnel_ends(const F& fresnel)
        : along_normal(fresnel(T(1))), grazing(fresnel(T(0))),
          dip((along_normal + (grazing - along_normal) * (T(7776) / T(16807)) - fresnel(T(1) / T(7))) *
              (T(823543) / T(46656))) {}
    constexpr S F0() const { return along_normal; }
    constexpr S F90() const { return grazing; }

private:
    S along_normal, grazing;

public:
    S dip;
};
/// Schlick's is its ends.
template <class F, scalar T>
    requires knows_both_ends<F>
class fresnel_ends<F, T> {
public:
    using S = std::decay_t<std::invoke_result_t<const F&, const T&>>;
    static constexpr bool dips = false;

    constexpr explicit fresnel_ends(const F& fresnel) : ends(fresnel) {}
    constexpr S F0() const { return ends.F0(); }
    constexpr S F90() const { return ends.F90(); }

private:
    F ends;
};

/// The energy that `smith_multiscatter` describes, for one Fresnel reflectance and one width.
template <class F, scalar T, class Terms, bool ByQuadrature>
class smith_energy {
    using ends = fresnel_ends<F, T>;

public:
    using S = typename ends::S;
    static constexpr bool by_quadrature = ByQuadrature || ends::dips;

    constexpr smith_energy(const F& reflectance, const alpha<T>& width, const Terms& dfg)
        : fresnel(reflectance), a(width), terms(dfg), p_alpha(p_exponent()) {}

    /// Of all bounces, and of those after the first.
    constexpr S total(const T& mu) const {
        const dfg_terms<T> t = terms(mu, a);
        return single(t) + later(mu, T(1) - t.albedo());
    }
    constexpr S single(const T& mu) const { return single(terms(mu, a)); }
    constexpr S operator()(const T& mu) const { return later(mu, T(1) - terms(mu, a).albedo()); }

    constexpr S single(const dfg_terms<T>& t) const { return fresnel.F0() * t.scale + fresnel.F90() * t.bias; }
    constexpr S later(const T& mu, const T& m) const {
        using std::exp, std::sqrt;
        const T p = exp(p_alpha - constant<T>(1.59) * mu), q = m * (constant<T>(.49) + constant<T>(.19) * m);
        S P = fresnel.F0() + (fresnel.F90() - fresnel.F0()) * p;
        if constexpr (ends::dips) {
            const T r = constant<T>(.061) * exp(constant<T>(-1.61) * sqrt(a.value()) - constant<T>(.36) * mu);
            P = by_component([](const T& x) { return smaller(larger(x, T(0)), T(1)); }, P - fresnel.dip * r);
        }
        return series(P, m, q);
    }

    /// 2 int_0^1 T mu dmu in closed form, for Schlick's Fresnel. No light where the facets lose less than 1e-6.
    constexpr S closed_average() const {
        using std::exp, std::sqrt;
        const dfg_terms<T> t = terms.average(a);
        const T s = sqrt(a.value()), p = exp(constant<T>(-3.89) * s);
        const T q = constant<T>(.17) + (constant<T>(.65) * s - constant<T>(.448)) * s;
        const S P = fresnel.F0() + (fresnel.F90() - fresnel.F0()) * p;
        return seen(series(P, T(1) - t.albedo(), q), t);
    }
    /// By 32 values of T, for any.
    constexpr S quadrature_average() const {
        constexpr gauss_legendre_32 rule;
        S total(T(0));
        for (int i = 0; i < 16; ++i)
            for (const double side : {-1.0, 1.0}) {
                const double x = 0.5 + side * 0.5 * rule.z[i], mu = x * x * x;
                total = total + (*this)(constant<T>(mu)) * constant<T>(rule.w[i] * 3 * x * x * mu);
            }
        return seen(total, terms.average(a));
    }
    constexpr S average() const {
        if constexpr (by_quadrature)
            return quadrature_average();
        else
            return closed_average();
    }
    /// The average of all bounces.
    constexpr S total_average() const { return single(terms.average(a)) + average(); }
    constexpr S F0() const { return fresnel.F0(); }

private:
    static constexpr S series(const S& P, const T& m, const T& q) {
        return by_component([&](const T& x) { return m * x * x * (T(1) - q) / (T(1) - q * x); }, P);
    }
    static constexpr S seen(const S& average, const dfg_terms<T>& t) {
        return average * select(T(1) - t.albedo() < constant<T>(1e-6), T(0), T(1));  // house: part of the model
    }
    constexpr T p_exponent() const {
        using std::pow;
        return constant<T>(-2.75) * pow(a.value(), constant<T>(.65));
    }

    ends fresnel;
    alpha<T> a;
    [[no_unique_address]] Terms terms;
    T p_alpha;
};

/// The albedo of a lobe's first bounce, for sharing samples.
template <class Energy>
struct first_bounce {
    Energy energy;
    template <scalar T>
    constexpr auto operator()(const T& mu) const {
        return energy.single(mu);
    }
};

/// ... of all.
template <class Energy>
struct all_bounces {
    Energy energy;
    template <scalar T>
    constexpr auto operator()(const T& mu) const {
        return energy.total(mu);
    }
};

}  // namespace detail

/// The second and all later bounces on isotropic GGX with `smith_correlated`, in closed form:
///   m = 1 - scale - bias,  p = exp(-2.75 alpha^0.65 - 1.59 mu),  q = m (0.49 + 0.19 m)
///   P = F0 + (F90 - F0) p,  T = m P^2 (1 - q)/(1 - q P)
/// p: the share of the grazing reflectance that later bounces see; P: what one of them reflects; T: the energy of all
/// of them, per channel. Fitted to the random walk (Heitz et al. 2016); it has no paper.
///   f = T(v) T(l)/(pi T_avg):  T_avg = m_avg P^2 (1 - q)/(1 - q P),  p = exp(-3.89 sqrt(alpha)),
///                              q = 0.17 - 0.448 sqrt(alpha) + 0.65 alpha
/// Reciprocal, positive, and lossless for F = 1. `dfg`: the provider of scale and bias.
/// F other than Schlick's: F90 = F(0), P less b r, b = (Schlick's - F)(1/7)/((1/7)(6/7)^6), r = 0.061 exp(-1.61
/// sqrt(alpha) - 0.36 mu), in [0,1]; T_avg by quadrature.
/// Error of the albedo against the random walk, mu in [0.02,1], alpha in [0.05,1], any F0: 0.002 (Fdez-Aguera 0.074,
/// Turquin 0.059, Kulla-Conty 0.048); gold and copper 0.005, iron, aluminium, titanium, chromium 0.004, dielectrics
/// 0.003, tints of 0.5 at 82 degrees 0.013.
/// Limits: not for other normals, maskings or anisotropic widths: take `kulla_conty` or `turquin` with a table.
/// The shape of the lobe is a product of functions of the two cosines; the walk's, of smooth surfaces, leans towards
/// the mirror direction: `forward()`.
template <class Terms = default_dfg, bool Forward = false, bool ByQuadrature = false>
class smith_multiscatter {
public:
    constexpr explicit smith_multiscatter(const Terms& dfg = {}) : terms(dfg) {}

    /// With light leaning towards the mirror direction: pull = exp(-(1.16 alpha + 6.35 alpha^2) F0^0.59), at most
    /// 0.995, F0 the mean of the channels. Halves the distance to the walk's lobe below alpha 0.25, changes nothing
    /// above 0.5.
    constexpr smith_multiscatter<Terms, true, ByQuadrature> forward() const {
        return smith_multiscatter<Terms, true, ByQuadrature>(terms);
    }
    /// With T_avg by 32 values of T instead of in closed form: albedos to 0.0015 instead of 0.002.
    constexpr smith_multiscatter<Terms, Forward, true> averaged_by_quadrature() const {
        return smith_multiscatter<Terms, Forward, true>(terms);
    }

    /// The energies of a Fresnel reflectance at a width: a callable of the cosine, T(mu), with `total`, `single`,
    /// `average`, `total_average`.
    template <class F, scalar T>
    constexpr auto energy(const F& fresnel, const alpha<T>& a) const {
        return detail::smith_energy<F, T, Terms, ByQuadrature>(fresnel, a, terms);
    }

    /// The lobe of later bounces alone, sampled by mu_l^2 = u^kappa, kappa = 1 + 2.5 exp(-7 alpha).
    template <class F, scalar T>
    constexpr auto lobe(const F& fresnel, const alpha<T>& a) const {
        using std::exp, std::pow;
        const auto e = energy(fresnel, a);
        using E = std::decay_t<decltype(e)>;
        using S = typename E::S;
        const auto k = [](double x) { return detail::constant<T>(x); };
        const T kappa = T(1) + k(2.5) * exp(k(-7) * a.value());
        if constexpr (Forward) {
            const T F0 = detail::mean<T>(e.F0());
            const T pull = exp((k(-1.16) - k(6.35) * a.value()) * a.value() * pow(F0, k(.59)));
            return multiple_scattering_lobe<S, E, forward_azimuth<T>>(e, kappa,
                                                                      forward_azimuth<T>(smaller(pull, k(.995))));
        } else {
            return multiple_scattering_lobe<S, E>(e, kappa);
        }
    }

    /// A microfacet lobe and what its later bounces add.
    template <class N, class M, class F, class Sampler>
    constexpr auto operator()(const microfacet<N, M, F, Sampler>& first) const {
        static_assert(Terms::template describes<N, M> && detail::is_smith_ggx<N, M>,
                      "smith_multiscatter is fitted for isotropic GGX with smith_correlated. For others take "
                      "kulla_conty{bake_dfg<float>(masking, {}, [](auto a) { return lobe::beckmann{a}; })}");
        const alpha a(first.normals().width().x);
        const auto e = energy(first.fresnel(), a);
        const detail::first_bounce<std::decay_t<decltype(e)>> albedo{e};
        return sum{detail::of_albedo(first, albedo), lobe(first.fresnel(), a)};
    }

    /// For image-based light: the later bounces with the prefiltered radiance where the surface is smooth, alpha < 0.1,
    /// with the irradiance where it is rough, alpha > 0.3. In a uniform light they are the same.
    template <class F, scalar T>
    constexpr auto weights(const F& fresnel, const T& mu, const alpha<T>& a) const {
        const auto e = energy(fresnel, a);
        using S = typename std::decay_t<decltype(e)>::S;
        const dfg_terms<T> t = terms(mu, a);
        const S later = e.later(mu, T(1) - t.albedo());
        const auto k = [](double x) { return detail::constant<T>(x); };
        const T x = smaller(larger((a.value() - k(.1)) * T(5), T(0)), T(1)), rough = x * x * (T(3) - T(2) * x);
        return ibl_weights<S>{e.single(t) + later * (T(1) - rough), later * rough};
    }
    /// ... over a diffuse base of that albedo: irradiance + albedo (1 - T).
    template <class F, scalar T, class S>
    constexpr ibl_weights<S> weights(const F& fresnel, const T& mu, const alpha<T>& a, const S& albedo) const {
        return detail::over_a_base(weights(fresnel, mu, a), albedo);
    }

private:
    [[no_unique_address]] Terms terms;
};

}  // namespace lobe
