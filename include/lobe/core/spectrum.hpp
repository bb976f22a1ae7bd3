// What spectra share: the number that one consists of, a formula for one wavelength applied to each, a range check.
#pragma once

#include <lobe/core/vector.hpp>

#include <limits>

namespace lobe {

namespace detail {

template <class S>
struct component {
    using type = double;
};
template <scalar S>
struct component<S> {
    using type = S;
};
template <class S>
    requires(!scalar<S> && requires { typename S::value_type; })
struct component<S> {
    using type = typename S::value_type;
};

}  // namespace detail

/// The number that a spectrum consists of: T for T and for vec3<T>, `value_type` of a type
/// of the user's own, else double.
template <class S>
using component_t = typename detail::component<S>::type;

namespace detail {

/// May a formula ask a spectrum S for a cosine of type T? Numbers, vectors and types that name
/// their `value_type` want that type: C++ and GLM would convert any other silently.
/// A type of the user's own that names none is trusted.
template <class T, class S>
concept component_of = scalar<T> &&
    (std::same_as<T, component_t<S>> || !(scalar<S> || requires { typename S::value_type; }));

// (Inlined by force: docs/design.md.)
template <class F, scalar T, std::same_as<T>... More>
[[gnu::always_inline]] constexpr T by_component(const F& f, const T& a, const More&... more) {
    return f(a, more...);
}
template <class F, scalar T, std::same_as<vec3<T>>... More>
[[gnu::always_inline]] constexpr vec3<T> by_component(const F& f, const vec3<T>& a, const More&... more) {
    return {f(a.x, more.x...), f(a.y, more.y...), f(a.z, more.z...)};
}

template <class P, scalar T>
constexpr bool every(const P& holds, const T& a) {
    return all(holds(a));
}
template <class P, scalar T>
constexpr bool every(const P& holds, const vec3<T>& a) {
    return all(holds(a.x)) && all(holds(a.y)) && all(holds(a.z));
}

/// Is every component in [0,1]? A type of the user's own is trusted.
template <class S>
constexpr bool in_unit_interval(const S& s) {
    if constexpr (requires { every([](const auto& x) { return x >= x; }, s); })
        return every([]<class T>(const T& x) { return x >= T(0) && x <= T(1); }, s);
    else
        return true;
}

/// The spectrum of a sum of A and B, one of which may be grey, a number of type T, beside the other's colours.
template <class T, class A, class B>
using mixed_t = std::conditional_t<std::same_as<A, T>, B, A>;
template <class T, class S, class... Grey>
struct mixed {
    using type = S;
};
template <class T, class A, class B, class... More>
struct mixed<T, A, B, More...> : mixed<T, mixed_t<T, A, B>, More...> {};

/// a times b, one of which may be grey: the one with colours first, as types of the user's own have `*` with a number.
template <scalar T, class A, class B>
[[gnu::always_inline]] constexpr mixed_t<T, A, B> product(const A& a, const B& b) {
    if constexpr (std::same_as<A, T>)
        return b * a;
    else
        return a * b;
}

/// What sums over many samples are kept in: double at least.
template <class T>
struct wide {
    using type = T;
};
template <>
struct wide<float> {
    using type = double;
};
template <glm::length_t N>
struct wide<glm::vec<N, float, glm::defaultp>> {
    using type = glm::vec<N, double, glm::defaultp>;
};
template <class T>
using wide_t = typename wide<T>::type;

/// A constant that is known to the precision of double.
template <class T>
constexpr T constant(double x) {
    return T(static_cast<lane_t<T>>(x));
}

/// Bits of precision; those of double for types that do not say.
template <class T>
constexpr int digits() {
    using limits = std::numeric_limits<lane_t<T>>;
    return limits::is_specialized ? limits::digits : 53;
}

}  // namespace detail

}  // namespace lobe
