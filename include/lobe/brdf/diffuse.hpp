// What the diffuse BRDFs share: the horizon, sampling, a width of 1.
#pragma once

#include <lobe/brdf/concepts.hpp>
#include <lobe/brdf/diffuse_samplers.hpp>
#include <lobe/core/spectrum.hpp>

#include <cassert>

namespace lobe {

/// A diffuse BRDF, sampled by a `diffuse_sampler`: pdf = share cos(theta_l)/pi, weight = pi f/share.
/// `Model` supplies pi f, times a factor, where both directions are above the horizon, and 0 elsewhere:
///   S pi_f(v, l, lit, factor) = select(lit, pi f(v,l) factor, 0).
/// v, l unit, in tangent space; all is zero unless both are above the horizon. f, pdf in 1/sr.
template <class Model, class S, class Sampler>
class diffuse_brdf : exact_vectors<Model> {
    using T = component_t<S>;
    using exact = exact_vectors<Model>;

public:
    using scalar = T;
    using spectrum = S;
    using exact::f, exact::f_cos, exact::pdf, exact::evaluate, exact::sample;
    static constexpr bool isotropic = true;

    constexpr S f(const vec3<T>& v, const vec3<T>& l) const {
        return model().pi_f(v, l, above_horizon(v, l), inv_pi<T>());
    }
    constexpr S f_cos(const vec3<T>& v, const vec3<T>& l) const {
        return model().pi_f(v, l, above_horizon(v, l), l.z * inv_pi<T>());
    }
    // (Inlined by force: docs/design.md.)
    [[gnu::always_inline]] constexpr T pdf(const vec3<T>& v, const vec3<T>& l) const {
        return pdf(v, l, Sampler{}.share(model(), v, l));
    }
    [[gnu::always_inline]] constexpr evaluation<S, T> evaluate(const vec3<T>& v, const vec3<T>& l) const {
        return {f_cos(v, l), pdf(v, l)};
    }

    /// u in [0,1)^2. Fails only where v is below the horizon.
    [[gnu::always_inline]] constexpr direction_sample<S, T> sample(const vec3<T>& v, const vec2<T>& u) const {
        // a view from below draws as its mirror image; `lit` drops the sample
        const vec3<T> l = Sampler{}.sample(model(), vec3<T>{v.x, v.y, absolute(v.z)}, u);
        const auto lit = above_horizon(v, l);
        const T share = Sampler{}.share(model(), v, l);
        return {select(lit, l, vec3<T>{T(0), T(0), T(1)}), model().pi_f(v, l, lit, quotient(lit, T(1), share)),
                pdf(v, l, share)};
    }

    /// pi f(v, n). A composition gives its lobes samples in proportion to this.
    constexpr S albedo_estimate(const vec3<T>& v) const {
        return model().pi_f(v, {T(0), T(0), T(1)}, v.z > horizon<T>(), T(1));
    }

    constexpr vec2<T> width() const { return {T(1), T(1)}; }

private:
    static constexpr T pdf(const vec3<T>& v, const vec3<T>& l, const T& share) {
        return select(above_horizon(v, l), l.z * inv_pi<T>() * share, T(0));
    }
    constexpr const Model& model() const { return static_cast<const Model&>(*this); }

    friend Model;
    constexpr diffuse_brdf() {
        static_assert(diffuse_sampler<Sampler, Model>, "the last part of a diffuse BRDF is a sampler for it");
        static_assert(samplable_brdf<Model>);
    }
};

/// A BRDF that is smooth enough to be sampled by the cosine alone.
template <class Model, class S>
using cosine_sampled = diffuse_brdf<Model, S, cosine_sampling>;

}  // namespace lobe
