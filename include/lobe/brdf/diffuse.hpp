// What the diffuse BRDFs share: the horizon, sampling in proportion to the cosine, a width of 1.
#pragma once

#include <lobe/brdf/concepts.hpp>
#include <lobe/core/spectrum.hpp>
#include <lobe/sampling/warp.hpp>

#include <cassert>

namespace lobe {

/// A BRDF that is smooth enough to be sampled by the cosine alone: pdf = cos(theta_l)/pi, and so weight = pi f.
/// `Model` supplies that weight, times a factor, where both directions are above the horizon, and 0 elsewhere:
///   S pi_f(v, l, lit, factor) = select(lit, pi f(v,l) factor, 0).
/// v, l unit, in tangent space; all is zero unless both are above the horizon. f, pdf in 1/sr.
template <class Model, class S>
class cosine_sampled : exact_vectors {
    using T = detail::component_t<S>;

public:
    using scalar = T;
    using spectrum = S;
    using exact_vectors::f, exact_vectors::f_cos, exact_vectors::pdf, exact_vectors::evaluate, exact_vectors::sample;
    static constexpr bool isotropic = true;

    constexpr S f(const vec3<T>& v, const vec3<T>& l) const { return model().pi_f(v, l, above_horizon(v, l), inv_pi<T>()); }
    constexpr S f_cos(const vec3<T>& v, const vec3<T>& l) const { return model().pi_f(v, l, above_horizon(v, l), l.z * inv_pi<T>()); }
    constexpr T pdf(const vec3<T>& v, const vec3<T>& l) const { return select(above_horizon(v, l), l.z * inv_pi<T>(), T(0)); }
    constexpr evaluation<S, T> evaluate(const vec3<T>& v, const vec3<T>& l) const { return {f_cos(v, l), pdf(v, l)}; }

    /// u in [0,1)^2. Fails only where v is below the horizon.
    constexpr direction_sample<S, T> sample(const vec3<T>& v, const vec2<T>& u) const {
        const vec3<T> l = square_to_cosine_hemisphere(u);
        const auto lit = above_horizon(v, l);
        return {select(lit, l, vec3<T>{T(0), T(0), T(1)}), model().pi_f(v, l, lit, T(1)), pdf(v, l)};
    }

    /// pi f(v, n): what a composition shares its samples by.
    constexpr S albedo_estimate(const vec3<T>& v) const { return model().pi_f(v, {T(0), T(0), T(1)}, v.z > horizon<T>(), T(1)); }

    constexpr vec2<T> width() const { return {T(1), T(1)}; }

private:
    constexpr const Model& model() const { return static_cast<const Model&>(*this); }

    friend Model;
    constexpr cosine_sampled() { static_assert(samplable_brdf<Model>); }
};

}  // namespace lobe
