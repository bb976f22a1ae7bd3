// What models of multiple scattering share: a reciprocal lobe of given albedo, and the weights of image-based light.
#pragma once

#include <lobe/brdf/microfacet.hpp>
#include <lobe/brdf/sum.hpp>
#include <lobe/energy/dfg.hpp>

#include <cmath>

namespace lobe {

/// What to multiply the prefiltered radiance and the irradiance/pi with.
template <class S>
struct ibl_weights {
    S radiance, irradiance;
};

namespace detail {

/// Weights of a specular lobe over a diffuse base: what it leaves is reflected as the albedo says.
template <class S>
constexpr ibl_weights<S> over_a_base(const ibl_weights<S>& specular, const S& albedo) {
    const S left = S(component_t<S>(1)) - specular.radiance - specular.irradiance;
    return {specular.radiance, specular.irradiance + albedo * left};
}

}  // namespace detail

/// The light of later bounces leaves without a preferred azimuth.
struct even_azimuth {
    template <scalar T>
    constexpr T pull() const {
        return T(0);
    }
};

/// It leaves around the azimuth of the mirror direction of v: k(dphi) = (1 - g^2)/(1 + g^2 - 2 g cos dphi), g =
/// pull sin(theta_v) sin(theta_l). Its mean over the circle is 1 and it is even in v and l, so that albedo, reciprocity
/// and sign stay as they are.
template <scalar T>
class forward_azimuth {
public:
    constexpr explicit forward_azimuth(const T& strength) : g(strength) {
        assert(all(g >= T(0)) && all(g < T(1)) && "forward_azimuth: the pull must be in [0,1)");
    }
    template <std::same_as<T> U>
    constexpr U pull() const {
        return g;
    }

private:
    T g;
};

/// f(v,l) = E(v) E(l)/(pi E_avg) k: the reciprocal lobe whose albedo is E(v). Kulla & Conty 2017, "Revisiting
/// Physically Based Shading at Imageworks"; here E may be coloured. `Energy`: E(mu), a spectrum, and `average()`, 2
/// int_0^1 E mu dmu: the albedo is E(v) as exactly as that holds. No lobe where the average is 0. Sampled by mu_l^2 =
/// u^kappa and by k: pdf = mu_l/pi x^(1/kappa - 1)/kappa k, x = mu_l^2; kappa = 1 is the cosine, more sends samples to
/// grazing angles.
template <class S, class Energy, class Azimuth = even_azimuth>
class multiple_scattering_lobe : exact_vectors<multiple_scattering_lobe<S, Energy, Azimuth>> {
    using T = component_t<S>;
    using exact = exact_vectors<multiple_scattering_lobe>;

public:
    using scalar = T;
    using spectrum = S;
    using exact::f, exact::f_cos, exact::pdf, exact::evaluate, exact::sample;
    static constexpr bool isotropic = true;

    constexpr multiple_scattering_lobe(const Energy& albedo, const T& kappa_of_sampling, const Azimuth& around = {})
        : energy(albedo), azimuth(around), kappa(kappa_of_sampling),
          over_average(detail::by_component([](const T& x) { return quotient(x > T(0), T(1), x); }, albedo.average())) {
        static_assert(samplable_brdf<multiple_scattering_lobe>);
    }

    constexpr S f(const vec3<T>& v, const vec3<T>& l) const { return over_pi(v, l, inv_pi<T>() * toward(v, l)); }
    constexpr S f_cos(const vec3<T>& v, const vec3<T>& l) const {
        return over_pi(v, l, inv_pi<T>() * toward(v, l) * l.z);
    }
    constexpr T pdf(const vec3<T>& v, const vec3<T>& l) const {
        const auto lit = above_horizon(v, l);
        return select(lit, density(select(lit, l.z, T(1))) * toward(v, l), T(0));
    }
    constexpr evaluation<S, T> evaluate(const vec3<T>& v, const vec3<T>& l) const { return {f_cos(v, l), pdf(v, l)}; }

    /// u in [0,1)^2. Fails where v is below the horizon, and for u.x = 0.
    constexpr direction_sample<S, T> sample(const vec3<T>& v, const vec2<T>& u) const {
        using std::pow, std::sqrt;
        const T x = pow(u.x, kappa), sine = sqrt(T(1) - x);
        // Uniform angles become as dense as k by tan(dphi/2) = (1 - g)/(1 + g) tan(angle/2), here by components.
        const T v2 = v.x * v.x + v.y * v.y, g = azimuth.template pull<T>() * sine * sqrt(v2);
        const auto [s, c] = sincos_2pi(u.y / T(2));
        const T hx = (T(1) + g) * c, hy = (T(1) - g) * s, h2 = hx * hx + hy * hy;
        const T along = (hx * hx - hy * hy) / h2, across = T(2) * hx * hy / h2;
        const auto tilted = v2 > T(0);  // else there is no mirror azimuth, and g = 0
        const T scale = sine / sqrt(select(tilted, v2, T(1)));
        const T mx = select(tilted, -v.x * scale, sine), my = select(tilted, -v.y * scale, T(0));
        const vec3<T> l{mx * along - my * across, my * along + mx * across, sqrt(x)};
        const auto lit = above_horizon(v, l);
        const vec3<T> up = select(lit, l, vec3<T>{T(0), T(0), T(1)});
        return {up, over_pi(v, up, select(lit, up.z * inv_pi<T>() / density(up.z), T(0))), pdf(v, up)};
    }

    constexpr S albedo_estimate(const vec3<T>& v) const { return energy(larger(v.z, horizon<T>())); }
    constexpr vec2<T> width() const { return {T(1), T(1)}; }

private:
    constexpr S over_pi(const vec3<T>& v, const vec3<T>& l, const T& factor) const {
        const auto lit = above_horizon(v, l);
        const T up(1);
        return energy(select(lit, v.z, up)) * energy(select(lit, l.z, up)) * over_average * select(lit, factor, T(0));
    }
    /// k; g cos(dphi) is -pull (v.l - v.z l.z).
    constexpr T toward(const vec3<T>& v, const vec3<T>& l) const {
        if constexpr (std::same_as<Azimuth, even_azimuth>)
            return T(1);
        else {
            const T p = azimuth.template pull<T>();
            const T g2 = p * p * ((v.x * v.x + v.y * v.y) * (l.x * l.x + l.y * l.y));
            return (T(1) - g2) / (T(1) + g2 + T(2) * p * (v.x * l.x + v.y * l.y));
        }
    }
    constexpr T density(const T& mu) const {
        using std::pow;
        return mu * inv_pi<T>() * pow(mu * mu, T(1) / kappa - T(1)) / kappa;
    }

    Energy energy;
    [[no_unique_address]] Azimuth azimuth;
    T kappa;
    S over_average;
};

namespace detail {

/// A microfacet lobe that says its albedo to a `sum`, which shares samples by it.
template <class Lobe, class Albedo>
class of_albedo : public Lobe {
    using T = typename Lobe::scalar;

public:
    constexpr of_albedo(const Lobe& lobe, const Albedo& of_cosine) : Lobe(lobe), albedo(of_cosine) {}
    constexpr typename Lobe::spectrum albedo_estimate(const vec3<T>& v) const {
        return albedo(larger(v.z, horizon<T>()));
    }

private:
    Albedo albedo;
};

}  // namespace detail

}  // namespace lobe
