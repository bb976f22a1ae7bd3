// Maps from the unit square: the map, its density, its inverse. u.x is radial and u.y azimuthal, except in the
// concentric maps, which keep the square's own axes. Densities of directions are in 1/sr.
// Error: 3e-7 in float (radian; of the disk: of its radius), 6e-16 in double.
#pragma once

#include <lobe/core/vector.hpp>

namespace lobe {

namespace detail {

/// The azimuth of (x, y) in turns, in [0,1).
template <scalar T>
constexpr T turns(const T& x, const T& y) {
    using std::atan2;
    const T t = atan2(y, x) * (inv_pi<T>() / T(2));
    const T positive = select(t < T(0), t + T(1), t);
    return select(positive < T(1), positive, T(0));  // a tiny negative azimuth rounds to a whole turn
}

}  // namespace detail

/// Uniform in the unit disk: r = sqrt(u.x), phi = 2 pi u.y.
template <scalar T>
constexpr vec2<T> square_to_uniform_disk(const vec2<T>& u) {
    using std::sqrt;
    const T r = sqrt(u.x);
    const auto [s, c] = sincos_2pi(u.y);
    return {r * c, r * s};
}

template <scalar T>
constexpr T uniform_disk_pdf() {
    return inv_pi<T>();
}

template <scalar T>
constexpr vec2<T> uniform_disk_to_square(const vec2<T>& p) {
    return {dot(p, p), detail::turns(p.x, p.y)};
}

namespace detail {

template <scalar T>
struct concentric_point {
    vec2<T> p;
    T edge;  // distance of the point's square ring from the edge: 0 at the rim, 1/2 at the centre
};

/// Shirley & Chiu 1997, "A Low Distortion Map Between Disk and Square": rings of the square become circles. Which ring
/// is told by the distances from the edges: near a corner 2 u - 1 is the same 1 for several u.
template <scalar T>
constexpr concentric_point<T> concentric(const vec2<T>& u) {
    const T a = T(2) * u.x - T(1), b = T(2) * u.y - T(1);
    const T edge_x = smaller(u.x, T(1) - u.x), edge_y = smaller(u.y, T(1) - u.y);
    const auto wide = edge_x < edge_y;
    const T r = select(wide, a, b), other = select(wide, b, a);
    const auto [s, c] = sincos_2pi(other / select(equal(r, T(0)), T(1), r) * T(0.125f));
    return {{r * select(wide, c, s), r * select(wide, s, c)}, smaller(edge_x, edge_y)};
}

}  // namespace detail

/// Uniform in the unit disk by concentric rings (Shirley & Chiu 1997): neighbours in the square stay neighbours.
template <scalar T>
constexpr vec2<T> square_to_uniform_disk_concentric(const vec2<T>& u) {
    return detail::concentric(u).p;
}

template <scalar T>
constexpr T uniform_disk_concentric_pdf() {
    return inv_pi<T>();
}

template <scalar T>
constexpr vec2<T> uniform_disk_concentric_to_square(const vec2<T>& p) {
    using std::atan2, std::sqrt;
    const T r = sqrt(dot(p, p));
    const auto wide = absolute(p.x) > absolute(p.y);
    const T sign = select(select(wide, p.x, p.y) < T(0), T(-1), T(1));
    const T major = sign * r;
    const T angle = atan2(sign * select(wide, p.y, p.x), absolute(select(wide, p.x, p.y)));  // in [-pi/4, pi/4]
    const T minor = major * angle * (T(4) * inv_pi<T>());
    return {(select(wide, major, minor) + T(1)) / T(2), (select(wide, minor, major) + T(1)) / T(2)};
}

/// Uniform in solid angle on the upper hemisphere: z = 1 - u.x.
template <scalar T>
constexpr vec3<T> square_to_uniform_hemisphere(const vec2<T>& u) {
    using std::sqrt;
    const T r = sqrt(u.x * (T(2) - u.x));
    const auto [s, c] = sincos_2pi(u.y);
    return {r * c, r * s, T(1) - u.x};
}

template <scalar T>
constexpr T uniform_hemisphere_pdf() {
    return inv_pi<T>() / T(2);
}

template <scalar T>
constexpr vec2<T> uniform_hemisphere_to_square(const vec3<T>& w) {
    return {(w.x * w.x + w.y * w.y) / (T(1) + w.z), detail::turns(w.x, w.y)};  // 1 - z without the cancellation
}

/// In proportion to the cosine: z = sqrt(1 - u.x) (Malley's method in polar form).
template <scalar T>
constexpr vec3<T> square_to_cosine_hemisphere(const vec2<T>& u) {
    using std::sqrt;
    const vec2<T> p = square_to_uniform_disk(u);
    return {p.x, p.y, sqrt(T(1) - u.x)};
}

/// cos(theta)/pi above the horizon, zero below.
template <scalar T>
constexpr T cosine_hemisphere_pdf(const vec3<T>& w) {
    return larger(w.z, T(0)) * inv_pi<T>();
}

template <scalar T>
constexpr vec2<T> cosine_hemisphere_to_square(const vec3<T>& w) {
    return uniform_disk_to_square(vec2<T>{w.x, w.y});
}

/// In proportion to the cosine, over concentric rings. z = sqrt(1 - r^2) with 1 - r^2 = 4 e (1 - e), e the distance to
/// the edge of the square.
template <scalar T>
constexpr vec3<T> square_to_cosine_hemisphere_concentric(const vec2<T>& u) {
    using std::sqrt;
    const auto [p, edge] = detail::concentric(u);
    return {p.x, p.y, T(2) * sqrt(edge * (T(1) - edge))};
}

template <scalar T>
constexpr T cosine_hemisphere_concentric_pdf(const vec3<T>& w) {
    return cosine_hemisphere_pdf(w);
}

template <scalar T>
constexpr vec2<T> cosine_hemisphere_concentric_to_square(const vec3<T>& w) {
    return uniform_disk_concentric_to_square(vec2<T>{w.x, w.y});
}

}  // namespace lobe
