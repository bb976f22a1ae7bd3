// The roles that a BRDF is composed from, the role of a BRDF, and what evaluating and sampling one returns.
#pragma once

#include <lobe/ndf/concepts.hpp>

namespace lobe {

/// A Fresnel reflectance: a callable of the cosine v.h; a lambda will do. (Multiple scattering asks for `average()`
/// too, the mean over the hemisphere weighted with the cosine: all of lobe's have it.)
template <class F, class T>
concept fresnel = requires(const F reflectance, const T u) {
    reflectance(u);
};

/// `evaluate(v, l)`: f(v,l) cos(theta_l), and the density with which `sample(v, u)` draws l, in 1/sr.
template <class S, scalar T>
struct evaluation {
    S f_cos;
    T pdf;
};

/// `sample(v, u)`: a light direction, its weight f_cos/pdf, and its density in 1/sr.
/// A failed sample has pdf = 0, weight = 0, l = (0,0,1).
template <class S, scalar T>
struct direction_sample {
    vec3<T> l;
    S weight;
    T pdf;
};

namespace detail {

/// What a part of a BRDF says of its creases, `for_each_crease(g)`: the cosines v.m in (0,1) at which it has a kink,
/// each to g. Most have none, and no such member.
template <class Part, class G>
constexpr void for_each_crease(const Part& part, const G& g) {
    if constexpr (requires { part.for_each_crease(g); }) part.for_each_crease(g);
}

/// Whether it says, by `smooth`, that it bends nowhere else: quadrature then needs fewer orders to know its error.
template <class Part>
constexpr bool smooth(const Part& part) {
    if constexpr (requires { part.smooth; })
        return part.smooth;
    else
        return false;
}

/// Does it say `transmits`? Then it scatters to both sides, and is no BRDF.
template <class B>
constexpr bool transmitting() {
    if constexpr (requires { bool(B::transmits); })
        return B::transmits;
    else
        return false;
}

}  // namespace detail

/// A BRDF: `f_cos(v, l)` is f(v,l) cos(theta_l), zero where v or l is below the horizon. `width()` is the scale of its
/// narrowest structure in half-vector slopes along x and y, for quadrature.
/// Parameters outside their domain end in an assert; where asserts are compiled out,
/// results mean nothing: NaN, or some number.
template <class B>
concept brdf =
    scalar<typename B::scalar> && !detail::transmitting<B>() && requires(const B b, const vec3<typename B::scalar> w) {
    typename B::spectrum;
    { B::isotropic } -> std::convertible_to<bool>;
    { b.f_cos(w, w) } -> std::same_as<typename B::spectrum>;
    { b.width() } -> std::same_as<vec2<typename B::scalar>>;
};

/// ... that draws light directions: u.x radial, u.y azimuthal, both in [0,1).
template <class B>
concept samplable_brdf = brdf<B> &&
    requires(const B b, const vec3<typename B::scalar> w, const vec2<typename B::scalar> u) {
    { b.sample(w, u) } -> std::same_as<direction_sample<typename B::spectrum, typename B::scalar>>;
    { b.pdf(w, w) } -> std::same_as<typename B::scalar>;
    { b.evaluate(w, w) } -> std::same_as<evaluation<typename B::spectrum, typename B::scalar>>;
};

/// GLM converts float and double vectors into each other silently. A BRDF `Self` that derives from this, and
/// `using`s its names, does not: vectors of any other type than its own find a deleted function. Compilers print its
/// line, which says what to do; its type is right, so that there is no second error. (`Self` keeps the bases of nested
/// BRDFs apart: two of one type would not share an address.)
template <class Self>
struct exact_vectors {
    // clang-format off
    template <class V, class L, class B = Self>
    typename B::spectrum f(const V&, const L&) const = delete;  // convert the vectors: vec3<T>(v)
    template <class V, class L, class B = Self>
    typename B::spectrum f_cos(const V&, const L&) const = delete;  // convert the vectors: vec3<T>(v)
    template <class V, class L, class B = Self>
    typename B::scalar pdf(const V&, const L&) const = delete;  // convert the vectors: vec3<T>(v)
    template <class V, class L, class B = Self>
    evaluation<typename B::spectrum, typename B::scalar>
    evaluate(const V&, const L&) const = delete;  // convert the vectors: vec3<T>(v)
    template <class V, class U, class B = Self>
    direction_sample<typename B::spectrum, typename B::scalar>
    sample(const V&, const U&) const = delete;  // convert the vectors: vec3<T>(v)
    // clang-format on
};

}  // namespace lobe
