// How a microfacet BRDF draws its half vectors: the fourth part of `microfacet`.
#pragma once

#include <lobe/ndf/concepts.hpp>

namespace lobe {

// A sampler is two functions: `sample(ndf, v, u)`, a unit normal, and `area(v_m, m_z, sv)`, which says how dense the
// reflected directions then are: their pdf is D(m) / (4 area), their weight F cos(theta_l) area / den.
// (v_m = v.m, m_z = cos(theta_m), sv = projected_area(v).)

/// Visible normals by spherical caps (Dupuy & Benyoub 2023): pdf = D/(4 sv), weight = F G2/G1, never above F.
struct visible_caps {
    template <visibly_samplable_distribution N, class T = typename N::scalar>
    constexpr vec3<T> sample(const N& ndf, const vec3<T>& v, const vec2<T>& u) const {
        return ndf.sample_visible(v, u);
    }
    template <scalar T>
    constexpr T area(const T&, const T&, const T& sv) const {
        return sv;
    }
};

/// All normals by inverse CDF, seen or not: pdf = D cos(theta_m) / (4 v.m). Simple, and noisy at grazing angles.
struct all_normals {
    template <samplable_distribution N, class T = typename N::scalar>
    constexpr vec3<T> sample(const N& ndf, const vec3<T>&, const vec2<T>& u) const {
        return ndf.sample(u);
    }
    template <scalar T>
    constexpr T area(const T& v_m, const T& m_z, const T&) const {
        return v_m / m_z;
    }
};

}  // namespace lobe
