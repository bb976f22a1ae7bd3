// World space to tangent space and back, and what normal maps make necessary: views below the shading horizon,
// light below the surface.
#pragma once

#include <lobe/core/vector.hpp>

#include <cassert>

namespace lobe {

/// An orthonormal basis around a unit normal, n = t x b. In its tangent space the normal is (0,0,1).
template <scalar T>
struct frame {
    vec3<T> t, b, n;

    /// Any azimuth: Duff et al. 2017, "Building an Orthonormal Basis, Revisited", listing 3.
    /// Domain: every unit normal, (0,0,-1) included. Error: orthonormal to 4 ULP of 1.
    constexpr explicit frame(const vec3<T>& normal) : frame(normal, select(normal.z < T(0), T(-1), T(1))) {}

    /// The azimuth of `tangent`, which need not be unit: its part along the normal is removed (Gram-Schmidt, done twice
    /// because once loses orthogonality in proportion to 1/sin of the angle between the two).
    /// Precondition: `tangent` is not parallel to the normal.
    /// Error: orthonormal to 4 ULP of 1.
    constexpr frame(const vec3<T>& normal, const vec3<T>& tangent)
        : t(across(normal, across(normal, tangent))), b(cross(normal, t)), n(normal) {
        assert(all(dot(cross(normal, tangent), cross(normal, tangent)) > T(0)) &&
               "frame: the tangent must not be parallel to the normal");
    }

    constexpr vec3<T> to_local(const vec3<T>& w) const { return {dot(w, t), dot(w, b), dot(w, n)}; }
    constexpr vec3<T> to_world(const vec3<T>& w) const { return w.x * t + w.y * b + w.z * n; }

private:
    /// Duff et al.'s formula, given the sign of n.z.
    constexpr frame(const vec3<T>& normal, const T& sign) : frame(normal, sign, T(-1) / (sign + normal.z)) {}
    constexpr frame(const vec3<T>& m, const T& sign, const T& p)
        : t(T(1) + sign * m.x * m.x * p, sign * m.x * m.y * p, -sign * m.x),
          b(m.x * m.y * p, sign + m.y * m.y * p, -m.y), n(m) {}

    static constexpr vec3<T> across(const vec3<T>& normal, const vec3<T>& w) {
        return normalize(w - dot(w, normal) * normal);
    }
};

/// Bends a view direction that a normal map or an interpolated normal put below the shading horizon: the direction of
/// the same azimuth whose cosine is `min_cosine`. Directions at or above it come back unchanged, to the bit. A renderer
/// calls this by name where it builds v; no formula does it silently.
/// Domain: unit v; min_cosine in (0,1). Straight down, which has no azimuth, bends towards x.
template <scalar T>
constexpr vec3<T> bend_above_horizon(const vec3<T>& v, const T& min_cosine) {
    using std::sqrt;
    const T sine2 = v.x * v.x + v.y * v.y;
    const auto has_azimuth =
        sine2 > T(1e-30f);  // house: below it the square has lost its digits, and v points straight down
    const T scale = sqrt((T(1) - min_cosine) * (T(1) + min_cosine) / select(has_azimuth, sine2, T(1)));
    const vec3<T> bent{select(has_azimuth, v.x, T(1)) * scale, select(has_azimuth, v.y, T(0)) * scale, min_cosine};
    return select(v.z < min_cosine, bent, v);
}

/// The share of the light from l that a normal map leaves: 0 where l is below the true surface,
/// whatever the tilted n sees of it, and a smooth way there. Multiply f_cos, and the weight of a sample, by it;
/// by name, as above: no formula does it silently.
///   G = 2 c/(c + sqrt(c^2 + a^2 s^2)),  c = cos(l, g), s = sin(l, g),  a^2 = min(tan^2(n, g)/8, 1)
/// Estevez, Lecocq, Stein 2019, "A Microfacet-Based Shadowing Function to Solve the Bump Terminator Problem"
/// (Ray Tracing Gems, chapter 12): the masking of a GGX as rough as the map is steep.
/// Domain: g, the true normal, and l: unit, in the tangent space of the mapped normal; g.z > 0. g = n gives 1.
/// Error: 8 ULP.
template <scalar T>
constexpr T bump_shadowing(const vec3<T>& g, const vec3<T>& l) {
    using std::sqrt;
    assert(all(g.z > T(0)) && "bump_shadowing: the true normal must be above the horizon of the mapped one");
    const vec3<T> across = cross(g, l);
    const T a2 = smaller((g.x * g.x + g.y * g.y) / (T(8) * g.z * g.z), T(1)), c = larger(dot(g, l), T(0));
    const auto lit = c > T(0);
    return quotient(lit, T(2) * c, c + sqrt(c * c + a2 * dot(across, across)));
}

}  // namespace lobe
