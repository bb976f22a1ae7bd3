// How a microfacet BRDF draws its half vectors: the fourth part of `microfacet`.
// Two more for GGX are in ggx_samplers.hpp.
#pragma once

#include <lobe/ndf/concepts.hpp>

namespace lobe {

/// A sampler for the distribution N is two functions:
/// - `sample(ndf, v, u)`: a positive multiple of a normal m, seen from v or not;
/// - `area(ndf, v, v_m, m_z, sv)`: how dense the directions reflected by these m are. Their pdf is D(m) / (4 area)
///   in 1/sr, their weight F cos(theta_l) area / den. (v_m = v.m and m_z = cos(theta_m), both times one positive
///   factor; sv = projected_area(v).)
template <class S, class N>
concept normal_sampler = distribution<N> && requires(const S sampler, const N ndf, const vec3<typename N::scalar> w,
                                                     const vec2<typename N::scalar> u, const typename N::scalar x) {
    { sampler.sample(ndf, w, u) } -> std::same_as<vec3<typename N::scalar>>;
    { sampler.area(ndf, w, x, x, x) } -> std::same_as<typename N::scalar>;
};

/// Visible normals by the distribution's own map, for GGX spherical caps (Dupuy & Benyoub 2023): pdf = D/(4 sv),
/// weight = F G2/G1, never above F with a Smith masking.
struct visible_normals {
    template <visibly_samplable_distribution N, class T = typename N::scalar>
    [[gnu::always_inline]] constexpr vec3<T> sample(const N& ndf, const vec3<T>& v, const vec2<T>& u) const {
        if constexpr (requires { ndf.sample_visible_multiple(v, u); })
            return ndf.sample_visible_multiple(v, u);
        else
            return ndf.sample_visible(v, u);
    }
    template <distribution N, class T = typename N::scalar>
    constexpr T area(const N&, const vec3<T>&, const T&, const T&, const T& sv) const {
        return sv;
    }
};

/// All normals by inverse CDF, seen or not: pdf = D cos(theta_m) / (4 v.m). Simple, and noisy at grazing angles.
struct all_normals {
    template <samplable_distribution N, class T = typename N::scalar>
    [[gnu::always_inline]] constexpr vec3<T> sample(const N& ndf, const vec3<T>&, const vec2<T>& u) const {
        if constexpr (requires { ndf.sample_multiple(u); })
            return ndf.sample_multiple(u);
        else
            return ndf.sample(u);
    }
    template <distribution N, class T = typename N::scalar>
    constexpr T area(const N&, const vec3<T>&, const T& v_m, const T& m_z, const T&) const {
        return larger(v_m, detail::smallest<T>()) / larger(m_z, detail::smallest<T>());  // behind, none is taken
    }
};

}  // namespace lobe
