// Masking and shadowing of a surface of V-shaped grooves.
#pragma once

#include <lobe/brdf/masking.hpp>

namespace lobe {

/// Every facet faces its mirror image across a long groove: G2 = min(1, 2 (n.m)(n.v)/(v.m), 2 (n.m)(n.l)/(v.m)).
/// Torrance & Sparrow 1967, "Theory for Off-Specular Reflection From Roughened Surfaces"; Cook & Torrance 1982, eq. for
/// G. With s = v + l, (v.m)/(n.m) = s.s/(2 s.z), so no half vector is normalised and nothing is divided by a cosine:
///   den = max(cos_v cos_l, max(cos_v, cos_l) s.s/(4 s.z))
/// Any distribution whose D(m) is symmetric about n; v, l unit, above the horizon; finite at grazing angles.
/// G2 has kinks. visible_normals still draws the normals that Smith's surface shows, so with this masking
/// a weight may exceed F.
/// Error: 6 ULP where v + l does not cancel.
struct v_cavity : masking_functions<v_cavity> {
    using masking_functions::denominator;
    template <distribution N, class T = typename N::scalar>
    constexpr T denominator(const N&, const vec3<T>& v, const vec3<T>& l, const T&) const {
        const vec3<T> s = v + l;
        return larger(v.z * l.z, quotient(s.z > T(0), larger(v.z, l.z), s.z) * dot(s, s) / T(4));
    }

    /// What v sees of the facets with unit normal m: min(1, 2 (n.m)(n.v)/(v.m)). It depends on m, as Smith's does not.
    /// Domain: v.m > 0.
    template <scalar T>
    constexpr T G1(const vec3<T>& v, const vec3<T>& m) const {
        return smaller(T(1), T(2) * m.z * v.z / dot(v, m));
    }
};

}  // namespace lobe
