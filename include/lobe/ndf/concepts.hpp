// The roles of a density of normals and of a distribution, which knows its projected area as well.
#pragma once

#include <lobe/width/alpha.hpp>

namespace lobe {

/// A density of normals:
/// - `D(m)`: 1/sr; of a direction, so any positive multiple of m; zero below the horizon;
/// - `width()`: the scale of its slopes along x and y, which quadrature wants to know.
/// Directions are of its own type. (GLM converts float and double vectors into each other silently; BRDFs refuse that.)
/// Parameters outside their domain end in an assert; where asserts are compiled out,
/// results mean nothing: NaN, or some number.
template <class N>
concept normal_density = scalar<typename N::scalar> && requires(const N ndf, const vec3<typename N::scalar> m) {
    { N::isotropic } -> std::convertible_to<bool>;
    { ndf.D(m) } -> std::same_as<typename N::scalar>;
    { ndf.width() } -> std::same_as<vec2<typename N::scalar>>;
};

/// ... that can be sampled: `sample(u)` draws normals with density `pdf(m) = D(m) cos(theta_m)`.
template <class N>
concept samplable_density = normal_density<N> &&
    requires(const N ndf, const vec2<typename N::scalar> u, const vec3<typename N::scalar> m) {
    { ndf.sample(u) } -> std::same_as<vec3<typename N::scalar>>;
    { ndf.pdf(m) } -> std::same_as<typename N::scalar>;
};

/// A distribution of normals is a density and what follows from it:
/// - `projected_area(w)`: sigma, the area of the microsurface seen from w per unit of macrosurface, its own back faces
///   excluded (Heitz et al. 2015, Dupuy 2015): cos(theta_w) (1 + Lambda(w)) in Smith's terms; on the whole sphere;
/// - `lambda(w)`: Smith's Lambda in a form that does not cancel; masking does not call it.
/// It may have shorter forms for what calls them: `projected_area_above(w)`, `projected_area_both(w)`, and samples that
/// are not normalised, `sample_multiple(u)`, `sample_visible_multiple(v, u)` (stretched.hpp).
/// Where there is no closed form the class is a density only; `tabulated` or `masked_by` makes a distribution of it.
template <class N>
concept distribution = normal_density<N> && requires(const N ndf, const vec3<typename N::scalar> w) {
    { ndf.projected_area(w) } -> std::same_as<typename N::scalar>;
    { ndf.lambda(w) } -> std::same_as<typename N::scalar>;
};

namespace detail {

template <class W>
struct number_in;
template <scalar W>
struct number_in<W> {
    using type = W;
};
template <std::integral W>
struct number_in<W> {
    using type = double;
};
template <width_type W>
struct number_in<W> {
    using type = typename W::scalar;
};

/// For deduction guides: the scalar type of a distribution that is written with a W for its width and a P behind it,
/// which if it is an integer becomes what the width is of; its width; and that of one that cannot be stretched.
template <class W, class P = int>
using number_t = std::conditional_t<scalar<P>, P, typename number_in<W>::type>;
template <class W, class P = int>
using width_t = std::conditional_t<width_of<W, number_t<W, P>>, W, refused_width<number_t<W, P>>>;
template <class W, class P = int>
using one_width_t = std::conditional_t<one_width_of<W, number_t<W, P>>, W, refused_width<number_t<W, P>>>;

/// The projected area from a direction above the horizon: by the distribution's shorter form, if it has one.
template <distribution N, class T = typename N::scalar>
constexpr T area_above(const N& ndf, const vec3<T>& w) {
    if constexpr (requires { ndf.projected_area_above(w); })
        return ndf.projected_area_above(w);
    else
        return ndf.projected_area(w);
}

}  // namespace detail

template <class N>
concept samplable_distribution = distribution<N> && samplable_density<N>;

/// ... whose visible normals can be sampled: `sample_visible(v, u)` with density
/// `pdf_visible(v, m) = max(0, v.m) D(m) / projected_area(v)` (Heitz & d'Eon 2014).
template <class N>
concept visibly_samplable_distribution = distribution<N> &&
    requires(const N ndf, const vec2<typename N::scalar> u, const vec3<typename N::scalar> w) {
    { ndf.sample_visible(w, u) } -> std::same_as<vec3<typename N::scalar>>;
    { ndf.pdf_visible(w, w) } -> std::same_as<typename N::scalar>;
};

}  // namespace lobe
