// The diffuse reflector of Lambert.
#pragma once

#include <lobe/brdf/concepts.hpp>
#include <lobe/sampling/warp.hpp>

#include <cassert>

namespace lobe {

/// f = albedo/pi, in 1/sr. Lambert 1760. Sampled in proportion to the cosine, so that the weight is the albedo.
/// S: one number or linear rgb, albedo in [0,1]; v, l unit, in tangent space; zero below the horizon.
template <class S>
class lambert : exact_vectors {
    using T = lane_t<S>;

public:
    using scalar = T;
    using spectrum = S;
    using exact_vectors::f, exact_vectors::f_cos, exact_vectors::pdf, exact_vectors::evaluate, exact_vectors::sample;
    static constexpr bool isotropic = true;

    constexpr explicit lambert(const S& albedo) : rho(albedo) { static_assert(samplable_brdf<lambert>); }

    constexpr S f(const vec3<T>& v, const vec3<T>& l) const { return rho * select(above(v, l), inv_pi<T>(), T(0)); }
    constexpr S f_cos(const vec3<T>& v, const vec3<T>& l) const { return rho * pdf(v, l); }
    constexpr T pdf(const vec3<T>& v, const vec3<T>& l) const { return select(above(v, l), l.z * inv_pi<T>(), T(0)); }
    constexpr evaluation<S, T> evaluate(const vec3<T>& v, const vec3<T>& l) const { return {f_cos(v, l), pdf(v, l)}; }

    constexpr direction_sample<S, T> sample(const vec3<T>& v, const vec2<T>& u) const {
        const vec3<T> l = square_to_cosine_hemisphere(u);
        const auto valid = above(v, l);
        return {select(valid, l, vec3<T>{T(0), T(0), T(1)}), rho * select(valid, T(1), T(0)), pdf(v, l)};
    }

    constexpr vec2<T> width() const { return {T(1), T(1)}; }

private:
    static constexpr auto above(const vec3<T>& v, const vec3<T>& l) { return v.z > T(0) && l.z > T(0); }

    S rho;
};

}  // namespace lobe
