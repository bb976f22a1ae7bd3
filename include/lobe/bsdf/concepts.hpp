// The role of a BSDF, which scatters light to both sides of a surface, and what its refraction carries.
#pragma once

#include <lobe/brdf/concepts.hpp>

namespace lobe {

/// What f transports across an interface, n = index where the light goes on over index where it comes from.
/// `radiance_transport`: L(v) = int f(v,l) L(l) |cos(theta_l)| dl; refraction is compressed into fewer directions, so
/// f holds (eta_v/eta_l)^2. Paths that start at the eye: the default.
/// `importance_transport`: f without this factor: the light that arrives along v leaves along l. Paths that start at a
/// light; energy is conserved in this form. Veach 1997, section 5.2.
/// Each is the transpose of the other: f_importance(v,l) = f_radiance(l,v).
struct radiance_transport {
    /// Of refraction, n = eta_l/eta_v.
    template <scalar T>
    static constexpr T scale(const T& n) {
        return T(1) / (n * n);
    }
};
struct importance_transport {
    template <scalar T>
    static constexpr T scale(const T&) {
        return T(1);
    }
};

template <class X>
concept transport = std::same_as<X, radiance_transport> || std::same_as<X, importance_transport>;

/// A BSDF: v and l anywhere on the sphere, `f_cos(v, l)` is f |cos(theta_l)|, and `transmits` says so.
/// Samples take three numbers, u.z choosing between reflection and refraction.
template <class B>
concept bsdf = scalar<typename B::scalar> && detail::transmitting<B>() &&
    requires(const B b, const vec3<typename B::scalar> w) {
    typename B::spectrum;
    { b.f_cos(w, w) } -> std::same_as<typename B::spectrum>;
    { b.pdf(w, w) } -> std::same_as<typename B::scalar>;
    { b.evaluate(w, w) } -> std::same_as<evaluation<typename B::spectrum, typename B::scalar>>;
    { b.sample(w, w) } -> std::same_as<direction_sample<typename B::spectrum, typename B::scalar>>;
};

}  // namespace lobe
