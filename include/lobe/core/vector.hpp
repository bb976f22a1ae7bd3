// Vectors are GLM's; the few operations on them are here, because GLM's compile for built-in numbers only.
#pragma once

#include <lobe/core/scalar.hpp>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace lobe {

template <scalar T>
using vec2 = glm::vec<2, T, glm::defaultp>;
template <scalar T>
using vec3 = glm::vec<3, T, glm::defaultp>;

template <scalar T>
constexpr T dot(const vec2<T>& a, const vec2<T>& b) {
    return a.x * b.x + a.y * b.y;
}

template <scalar T>
constexpr T dot(const vec3<T>& a, const vec3<T>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <scalar T>
constexpr vec3<T> cross(const vec3<T>& a, const vec3<T>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <scalar T>
constexpr T length(const vec3<T>& a) {
    using std::sqrt;
    return sqrt(dot(a, a));
}

/// Domain: any vector whose squared length neither vanishes nor overflows.
template <scalar T>
constexpr vec3<T> normalize(const vec3<T>& a) {
    const T s = length(a);
    return {a.x / s, a.y / s, a.z / s};
}

/// The direction that `v` is mirrored to by a facet with unit normal `m`: 2 (v.m) m - v.
/// Both point away from the surface.
template <scalar T>
constexpr vec3<T> reflect(const vec3<T>& v, const vec3<T>& m) {
    return T(2) * dot(v, m) * m - v;
}

/// The microfacet normal m that mirrors v to l. Evaluations need no unit half vector: they use v + l as it is.
template <scalar T>
constexpr vec3<T> half_vector(const vec3<T>& v, const vec3<T>& l) {
    return normalize(v + l);
}

/// Are both above the horizon, where a BRDF is not 0? (-> `horizon`)
template <scalar T>
constexpr auto above_horizon(const vec3<T>& v, const vec3<T>& l) {
    return v.z > horizon<T>() && l.z > horizon<T>();
}

/// Component by component, which compilers vectorise, as they do not the choice between two whole vectors.
template <class Mask, scalar T>
constexpr vec3<T> select(const Mask& mask, const vec3<T>& a, const vec3<T>& b) {
    return {select(mask, a.x, b.x), select(mask, a.y, b.y), select(mask, a.z, b.z)};
}

}  // namespace lobe
