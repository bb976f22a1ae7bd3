// The two numbers of the split sum, who provides them, and their exact values.
#pragma once

#include <lobe/brdf/microfacet.hpp>
#include <lobe/energy/albedo.hpp>
#include <lobe/ndf/ggx.hpp>

namespace lobe {

/// The directional albedo of a microfacet lobe with Schlick's Fresnel is F0 * scale + F90 * bias: Karis 2013, "Real
/// Shading in Unreal Engine 4". scale = int f (1 - Fc) cos dl, bias = int f Fc cos dl, Fc = (1 - v.m)^5, with F = 1 in
/// f.
template <scalar T>
struct dfg_terms {
    T scale, bias;

    /// E: the albedo of the same lobe at F = 1.
    constexpr T albedo() const { return scale + bias; }
};

/// Who knows the terms: a small value, called with the cosine of the view and the width. `average(alpha)` is 2 int_0^1
/// (scale, bias) mu dmu of the same provider, so that what is compensated with both adds up. `describes<N, Masking>`:
/// is it for the normals N and this masking?
template <class P, class T>
concept dfg_provider = scalar<T> && requires(const P p, const T mu, const alpha<T> a) {
    { p(mu, a) } -> std::same_as<dfg_terms<T>>;
    { p.average(a) } -> std::same_as<dfg_terms<T>>;
};

/// Isotropic GGX of a width: the normals that tables and exact terms are of, unless they are told others, as a callable
/// of `alpha`: `[](auto a) { return lobe::beckmann{a}; }`.
struct ggx_of_width {
    template <scalar T>
    constexpr ggx<T> operator()(const alpha<T>& a) const {
        return ggx<T>{a};
    }
};

namespace detail {

template <class N, class Masking>
concept is_smith_ggx = std::same_as<N, ggx<typename N::scalar>> && std::same_as<Masking, smith_correlated>;

/// Schlick's Fresnel with F0 and F90 taken out: (1 - Fc, Fc) is its spectrum.
struct schlick_terms {
    template <scalar T>
    constexpr vec2<T> operator()(const T& u) const {
        const T w = T(1) - u;
        const T w2 = w * w, Fc = w2 * w2 * w;
        return {T(1) - Fc, Fc};
    }
    constexpr double average() const { return 1; }
};

/// 2 int_0^1 (scale, bias) mu dmu of a provider, with 32 nodes that crowd towards grazing like a cube: mu = x^3.
/// Error: 1e-6 of smooth terms; branch-free.
template <scalar T, class Provider>
constexpr dfg_terms<T> dfg_average(const Provider& terms, const alpha<T>& a) {
    constexpr gauss_legendre_32 rule;
    dfg_terms<T> total{T(0), T(0)};
    for (int i = 0; i < 16; ++i)
        for (const double side : {-1.0, 1.0}) {
            const double x = 0.5 + side * 0.5 * rule.z[i], mu = x * x * x;
            const dfg_terms<T> t = terms(constant<T>(mu), a);
            const T weight = constant<T>(rule.w[i] * 3 * x * x * mu);  // half the rule's, times 2 mu dmu/dx
            total = {total.scale + t.scale * weight, total.bias + t.bias * weight};
        }
    return total;
}

}  // namespace detail

namespace detail {

/// What the quadrature integrates: scale and bias of a lobe seen from v.
template <class N, class Masking, class T = typename N::scalar>
struct split_sum {
    microfacet<N, Masking, schlick_terms> lobe;
    vec3<T> v;

    split_sum(const N& ndf, const Masking& masking_model, const vec3<T>& view)
        : lobe(ndf, masking_model, schlick_terms{}), v(view) {}

    vec2<T> operator()(const vec3<T>& l) const { return lobe.f_cos(v, l); }

    dfg_terms<T> at(const hemisphere_rule<T>& rule) const {
        const vec2<T> terms = hemisphere_integral_at(*this, v, lobe.width(), N::isotropic, rule);
        return {terms.x, terms.y};
    }
};

}  // namespace detail

/// The split-sum terms by quadrature, of isotropic GGX or of the normals that `of_width` makes of an `alpha`.
/// Domain: mu = cos(theta_v) in (0,1], alpha mu >= 1e-13 (alpha from 1e-10 for mu from 1e-3): there within 4e-6 of the
/// limit alpha = 0; below, the rounding of l in double is too much for D, and soon makes a NaN. Computed in double for
/// float. `options` may ask for an order instead of a tolerance: 2 order^2 evaluations.
/// Error of GGX: 5e-6 at order 16, 2e-8 at 32, for mu and alpha in [0.001,1].
template <scalar T, class Masking, class OfWidth = ggx_of_width>
dfg_terms<T> dfg_exact(const Masking& masking_model, const T& mu, const alpha<T>& a, const quadrature& options = {},
                       const OfWidth& of_width = {}) {
    using W = detail::wide_t<T>;
    assert(mu > T(0) && mu <= T(1) && "dfg_exact: the cosine must be in (0,1]");
    const detail::split_sum terms(of_width(alpha<W>(W(a.value()))), masking_model, detail::view_at(W(mu)));
    if (options.order) {
        const dfg_terms<W> t = terms.at(options.order);
        return {T(t.scale), T(t.bias)};
    }
    const vec2<W> t = hemisphere_integral(terms, terms.v, terms.lobe.width(), true, options).value;
    return {T(t.x), T(t.y)};
}

/// `dfg_exact` as a provider: for tests and references. Scalar types only.
template <class Masking, class OfWidth = ggx_of_width>
class exact_dfg {
public:
    constexpr explicit exact_dfg(const Masking& masking_model = {}, const OfWidth& of_width = {},
                                 const quadrature& how_hard = {.order = 32})
        : shadow(masking_model), make(of_width), options(how_hard) {}

    template <class N, class M>
    static constexpr bool describes = std::same_as<M, Masking>&&
        std::same_as<N, std::decay_t<std::invoke_result_t<OfWidth, alpha<typename N::scalar>>>>;

    template <scalar T>
    dfg_terms<T> operator()(const T& mu, const alpha<T>& a) const {
        return dfg_exact(shadow, mu, a, options, make);
    }
    template <scalar T>
    dfg_terms<T> average(const alpha<T>& a) const {
        return detail::dfg_average(*this, a);
    }

private:
    [[no_unique_address]] Masking shadow;
    [[no_unique_address]] OfWidth make;
    quadrature options;
};

}  // namespace lobe
