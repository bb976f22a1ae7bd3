// The role of a distribution of normals.
#pragma once

#include <lobe/core/roughness.hpp>

namespace lobe {

/// A distribution of normals is two functions and what follows from them:
/// - `D(m)`: density of normals, 1/sr; of a direction, so any positive multiple of m; zero below the horizon;
/// - `projected_area(w)`: sigma, the area of the microsurface seen from w per unit of macrosurface, its own back faces
///   excluded (Heitz et al. 2015, Dupuy 2015): cos(theta_w) (1 + Lambda(w)) in Smith's terms; on the whole sphere;
/// - `lambda(w)`: Smith's Lambda in a form that does not cancel; masking does not call it;
/// - `width()`: the scale of its slopes along x and y, which quadrature wants to know.
/// Directions are of its own type: GLM converts float and double vectors into each other without a word, which only a BRDF refuses.
/// Parameters outside their domain end in an assert; where asserts are compiled out, results mean nothing: NaN, or some number.
template <class N>
concept distribution = scalar<typename N::scalar> && requires(const N ndf, const vec3<typename N::scalar> w) {
    { N::isotropic } -> std::convertible_to<bool>;
    { ndf.D(w) } -> std::same_as<typename N::scalar>;
    { ndf.projected_area(w) } -> std::same_as<typename N::scalar>;
    { ndf.lambda(w) } -> std::same_as<typename N::scalar>;
    { ndf.width() } -> std::same_as<vec2<typename N::scalar>>;
};

namespace detail {

template <class Width, scalar T>
struct width_in {
    static_assert(std::same_as<typename Width::scalar, T>,
                  "the parameters of a distribution are of its width's type: student_t{alpha{0.3f}, 2.0f}, not 2.0");
    using type = Width;
};
/// The width of a distribution whose other parameters are T.
template <class Width, scalar T>
using width_in_t = typename width_in<Width, T>::type;

/// The projected area from a direction above the horizon: by the distribution's shorter form, if it has one.
template <distribution N, class T = typename N::scalar>
constexpr T area_above(const N& ndf, const vec3<T>& w) {
    if constexpr (requires { ndf.projected_area_above(w); })
        return ndf.projected_area_above(w);
    else
        return ndf.projected_area(w);
}

}  // namespace detail

/// ... that can be sampled: `sample(u)` draws normals with density `pdf(m) = D(m) cos(theta_m)`.
template <class N>
concept samplable_distribution =
    distribution<N> && requires(const N ndf, const vec2<typename N::scalar> u, const vec3<typename N::scalar> m) {
        { ndf.sample(u) } -> std::same_as<vec3<typename N::scalar>>;
        { ndf.pdf(m) } -> std::same_as<typename N::scalar>;
    };

/// ... and whose visible normals can be sampled: `sample_visible(v, u)` with density
/// `pdf_visible(v, m) = max(0, v.m) D(m) / projected_area(v)` (Heitz & d'Eon 2014).
template <class N>
concept visibly_samplable_distribution = distribution<N> && requires(const N ndf, const vec2<typename N::scalar> u,
                                                                     const vec3<typename N::scalar> w) {
    { ndf.sample_visible(w, u) } -> std::same_as<vec3<typename N::scalar>>;
    { ndf.pdf_visible(w, w) } -> std::same_as<typename N::scalar>;
};

}  // namespace lobe
