// Disney's diffuse reflector, and Frostbite's renormalisation of it.
#pragma once

#include <lobe/brdf/diffuse.hpp>

namespace lobe {

namespace detail {

/// (1 + (F90 - 1)(1 - cos(theta_l))^5) (1 + (F90 - 1)(1 - cos(theta_v))^5).
template <scalar T>
constexpr T burley_shape(const vec3<T>& v, const vec3<T>& l, const T& F90) {
    const T a = T(1) - v.z, a2 = a * a, b = T(1) - l.z, b2 = b * b;
    return (T(1) + (F90 - T(1)) * (b2 * b2 * b)) * (T(1) + (F90 - T(1)) * (a2 * a2 * a));
}

/// 2 (l.h)^2 = 1 + v.l, without the half vector.
template <scalar T>
constexpr T twice_squared_difference_cosine(const vec3<T>& v, const vec3<T>& l) {
    return T(1) + dot(v, l);
}

}  // namespace detail

/// f = rho/pi (1 + (F90 - 1)(1 - cos(theta_l))^5)(1 + (F90 - 1)(1 - cos(theta_v))^5), F90 = 1/2 + 2 r (l.h)^2.
/// Burley 2012, "Physically-Based Shading at Disney", section 5.3. r: perceptual roughness
/// (not alpha), rho: both in [0,1].
/// Reciprocal, but it gains energy: albedo at rho = 1 from 0.488 (r = 0) to 1.56 (r = 1),
/// both at grazing. Rounding: 12 ULP.
template <class S>
class burley : public cosine_sampled<burley<S>, S> {
    using T = component_t<S>;

public:
    constexpr burley(const S& albedo, const T& roughness) : rho(albedo), r(roughness) {
        assert(detail::in_unit_interval(rho) && "burley: the albedo must be in [0,1]");
        assert(detail::in_unit_interval(r) && "burley: roughness must be in [0,1]");
    }

private:
    friend cosine_sampled<burley, S>;

    template <class Mask>
    constexpr S pi_f(const vec3<T>& v, const vec3<T>& l, const Mask& lit, const T& factor) const {
        const T F90 = T(0.5f) + r * detail::twice_squared_difference_cosine(v, l);
        return rho * select(lit, detail::burley_shape(v, l, F90) * factor, T(0));
    }

    S rho;
    T r;
};

/// The same with F90 = r/2 + 2 r (l.h)^2, and times 1 + (1/1.51 - 1) r.
/// Lagarde & de Rousiers 2014, "Moving Frostbite to Physically Based Rendering", listing 2. r: perceptual roughness;
/// rho, r in [0,1]. Albedo at rho = 1: at most 1.032; meant to be added to a specular lobe,
/// so it falls to 0 at grazing where r = 0.
/// Rounding: 12 ULP, or of rho/5 where a factor vanishes (r = 0, grazing).
template <class S>
class burley_frostbite : public cosine_sampled<burley_frostbite<S>, S> {
    using T = component_t<S>;

public:
    constexpr burley_frostbite(const S& albedo, const T& roughness)
        : rho(albedo), r(roughness), scale(T(1) + (T(100) / T(151) - T(1)) * roughness) {
        assert(detail::in_unit_interval(rho) && "burley: the albedo must be in [0,1]");
        assert(detail::in_unit_interval(r) && "burley: roughness must be in [0,1]");
    }

private:
    friend cosine_sampled<burley_frostbite, S>;

    template <class Mask>
    constexpr S pi_f(const vec3<T>& v, const vec3<T>& l, const Mask& lit, const T& factor) const {
        const T F90 = r * (T(0.5f) + detail::twice_squared_difference_cosine(v, l));
        return rho * select(lit, detail::burley_shape(v, l, F90) * scale * factor, T(0));
    }

    S rho;
    T r, scale;
};

}  // namespace lobe
