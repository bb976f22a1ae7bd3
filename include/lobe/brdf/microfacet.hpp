// The microfacet BRDF of Cook and Torrance, composed from a distribution, a masking model,
// a Fresnel reflectance and a sampler.
#pragma once

#include <lobe/brdf/concepts.hpp>
#include <lobe/brdf/masking.hpp>
#include <lobe/brdf/samplers.hpp>

namespace lobe {

namespace detail {

/// A Fresnel reflectance for the distribution N: it takes N's scalar type.
template <class F, class N>
concept fresnel_for = distribution<N> && fresnel<F, typename N::scalar>;

}  // namespace detail

/// Reached by parts that do not fit: says which is the first that does not, and what to write. What is evaluated of
/// it is of any type, so that there is no second error.
template <class N, class M, class F, class Sampler = visible_normals>
class microfacet {
    static constexpr bool area = distribution<N> || !normal_density<N>, first = distribution<N> || !area;
    static constexpr bool second = masking<M, N> || !distribution<N>;
    static constexpr bool third = detail::fresnel_for<F, N> || !masking<M, N>;
    static_assert(area, "these normals have no projected area in closed form: write tabulated{...}, built once, or "
                        "masked_by{..., ggx{alpha{0.3f}}}");
    static_assert(
        first,
        "microfacet{distribution, masking, Fresnel}: the first part is a distribution of normals, ggx{alpha{0.3f}}");
    static_assert(
        second, "microfacet{distribution, masking, Fresnel}: the second is a masking model for it, smith_correlated{}");
    static_assert(
        third, "microfacet{distribution, masking, Fresnel}: the third is a callable of v.m in the scalar type of the "
               "distribution: schlick{0.04f} for ggx{alpha{0.3f}}, schlick{0.04} for ggx{alpha{0.3}}");

    struct anything {
        template <class X>
        operator X() const;
    };
    struct answer {
        anything f_cos, l, weight, pdf;
    };

public:
    constexpr microfacet(const N&, const M&, const F&, const Sampler& = {}) {}
    template <class... W>
    anything f(const W&...) const;
    template <class... W>
    anything f_cos(const W&...) const;
    template <class... W>
    anything pdf(const W&...) const;
    template <class... W>
    answer evaluate(const W&...) const;
    template <class... W>
    answer sample(const W&...) const;
};

/// f(v,l) = F(v.m) D(m) G2(v,l) / (4 cos(theta_v) cos(theta_l)) = F D / (4 den), in 1/sr. Cook & Torrance 1982; Walter
/// et al. 2007, eq. 20. Nothing is divided by a cosine and no half vector is normalised: with s = v + l, D takes s as
/// it is and v.m = |s|/2.
/// v, l unit, in tangent space; f, f_cos, pdf are zero unless both are above the horizon. Reciprocal to rounding.
/// Error of f_cos and pdf, GGX and Schlick, for v and l as they are given: 20 ULP.
/// Sampled where the sampler can draw normals of the distribution.
/// Domain: any two directions; 0 from the horizon down, a cosine of 2^-60 in float,
/// 2^-500 in double (`horizon`), below which |v + l|^2 would underflow near l = -v.
/// Just above it D loses digits as alpha^2 |v + l|^2 underflows (docs/limits.md).
template <class N, class M, class F, class Sampler>
    requires(distribution<N>&& masking<M, N>&& detail::fresnel_for<F, N>)
class microfacet<N, M, F, Sampler> : exact_vectors<microfacet<N, M, F, Sampler>> {
    using T = typename N::scalar;
    using S = decltype(std::declval<const F&>()(std::declval<const T&>()));
    using exact = exact_vectors<microfacet>;

public:
    using scalar = T;
    using spectrum = S;
    using exact::f, exact::f_cos, exact::pdf, exact::evaluate, exact::sample;
    static constexpr bool isotropic = N::isotropic;

    constexpr microfacet(const N& distribution_of_normals, const M& masking_model, const F& reflectance,
                         const Sampler& sampling = {})
        : ndf(distribution_of_normals), shadow(masking_model), fresnel_(reflectance), sampler(sampling) {
        static_assert(brdf<microfacet>);
    }

    // (Inlined by force, all of it: docs/design.md.)
    [[gnu::always_inline]] constexpr S f(const vec3<T>& v, const vec3<T>& l) const {
        const half h(v + l);
        const T beside_F = quotient(above_horizon(v, l), ndf.D(h.s), T(4) * shadow.denominator(ndf, v, l));
        return fresnel_(h.v_m) * smaller(beside_F, detail::largest<T>());  // F = 0 times infinity is a NaN
    }

    [[gnu::always_inline]] constexpr S f_cos(const vec3<T>& v, const vec3<T>& l) const {
        const half h(v + l);
        return fresnel_(h.v_m) * quotient(above_horizon(v, l), ndf.D(h.s) * l.z, T(4) * shadow.denominator(ndf, v, l));
    }

    [[gnu::always_inline]] constexpr T pdf(const vec3<T>& v,
                                           const vec3<T>& l) const requires normal_sampler<Sampler, N> {
        const half h(v + l);
        return quotient(above_horizon(v, l), ndf.D(h.s),
                        T(4) * sampler.area(ndf, v, h.v_m, h.m_z(), detail::area_above(ndf, v)));
    }

    /// f_cos and pdf together, sharing their work: for multiple importance sampling.
    [[gnu::always_inline]] constexpr evaluation<S, T>
    evaluate(const vec3<T>& v, const vec3<T>& l) const requires normal_sampler<Sampler, N> {
        const half h(v + l);
        const auto above = above_horizon(v, l);
        const T sv = detail::area_above(ndf, v);
        const T D = ndf.D(h.s) / T(4);
        return {fresnel_(h.v_m) * quotient(above, D * l.z, shadow.denominator(ndf, v, l, sv)),
                quotient(above, D, sampler.area(ndf, v, h.v_m, h.m_z(), sv))};
    }

    /// u in [0,1)^2. Fails where v is below the horizon or the sampled facet reflects it there, or its density is below
    /// the smallest number of T.
    [[gnu::always_inline]] constexpr direction_sample<S, T>
    sample(const vec3<T>& v, const vec2<T>& u) const requires normal_sampler<Sampler, N> {
        using std::sqrt;
        const vec3<T> w = upward(v);                  // from straight below no normal is visible
        const vec3<T> n = sampler.sample(ndf, w, u);  // |n| m
        const T v_n = dot(w, n), k = T(2) * v_n / larger(dot(n, n), detail::smallest<T>());
        const vec3<T> l{k * n.x - w.x, k * n.y - w.y, k * n.z - w.z};  // 2 (v.m) m - v
        const auto above = above_horizon(v, l);
        const T v_m = sqrt(v_n * k / T(2)), sv = detail::area_above(ndf, w);
        const T area = sampler.area(ndf, w, v_n, n.z, sv), density = ndf.D(upward(n)) / (T(4) * area);
        const auto valid = above && density > T(0);  // a Gaussian tail may underflow
        return {select(valid, l, vec3<T>{T(0), T(0), T(1)}),
                fresnel_(select(valid, smaller(v_m, T(1)), T(1))) *
                    quotient(valid, l.z * area, shadow.denominator(ndf, w, l, sv)),
                select(valid, density, T(0))};
    }

    /// F(n.v). A composition gives its lobes samples in proportion to this.
    [[gnu::always_inline]] constexpr S albedo_estimate(const vec3<T>& v) const {
        return fresnel_(smaller(larger(v.z, T(0)), T(1)));
    }

    constexpr vec2<T> width() const { return ndf.width(); }
    constexpr const N& normals() const { return ndf; }
    constexpr const F& fresnel() const { return fresnel_; }

    /// As the masking is; what else bends says where, or shows in the orders of a quadrature.
    static constexpr bool smooth = requires { requires M::smooth; };
    /// The critical angles of the Fresnel reflectance: where quadrature cuts.
    template <class G>
    constexpr void for_each_crease(const G& g) const {
        detail::for_each_crease(fresnel_, g);
    }

private:
    /// w, or its mirror image where w is below the horizon: so no formula asks where w is.
    /// The result is not used there.
    static constexpr vec3<T> upward(const vec3<T>& w) { return {w.x, w.y, absolute(w.z)}; }

    /// The half vector as v + l.
    struct half {
        vec3<T> s;
        T v_m;  // v.m = |s|/2, which rounding may take above 1
        constexpr explicit half(const vec3<T>& sum) : s(upward(sum)), v_m(smaller(length(s) / T(2), T(1))) {}
        constexpr T m_z() const { return s.z / (T(2) * larger(v_m, detail::smallest<T>())); }
    };

    [[no_unique_address]] N ndf;
    [[no_unique_address]] M shadow;
    [[no_unique_address]] F fresnel_;
    [[no_unique_address]] Sampler sampler;
};

}  // namespace lobe
