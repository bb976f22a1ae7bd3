// The width of a distribution of normals, as types: a bare number is never taken for a width or for a roughness.
#pragma once

#include <lobe/core/vector.hpp>

#include <cassert>

namespace lobe {

/// The width alpha of an isotropic distribution (Walter et al. 2007): the scale of its slopes.
/// Precondition: alpha > 0. Artists' roughness is converted by name, and a floor is written where the number is born.
template <scalar T>
class alpha {
public:
    using scalar = T;
    static constexpr bool isotropic = true;

    constexpr explicit alpha(const T& value) : a(value) { assert(all(a > T(0))); }

    /// alpha = r^2 (Burley 2012, "Physically-Based Shading at Disney", section 5.4).
    static constexpr alpha from_roughness(const T& r) { return alpha(r * r); }
    /// The same, at least `floor`, for roughness from a texture: textures contain 0.
    static constexpr alpha from_roughness(const T& r, const T& floor) { return at_least(r * r, floor); }
    static constexpr alpha at_least(const T& value, const T& floor) { return alpha(max(value, floor)); }

    constexpr T value() const { return a; }
    constexpr T x() const { return a; }
    constexpr T y() const { return a; }

    /// A direction of the microsurface of width 1 and what it becomes when the surface is stretched, (a x, a y, z):
    /// the map of normals from width 1 to this width, and of views from this width to width 1. Not normalised.
    constexpr vec3<T> stretch(const vec3<T>& w) const { return {a * w.x, a * w.y, w.z}; }

    /// A positive multiple of the normal that `stretch` maps to m.
    constexpr vec3<T> unstretch(const vec3<T>& m) const { return {m.x, m.y, a * m.z}; }

    /// D(m) of the stretched distribution over D of the one of width 1 at `unstretch(m)`, for any positive multiple of m:
    /// ( a (m.m) / (x^2 + y^2 + a^2 z^2) )^2. Components, because 1 - z^2 cancels; no square of a^2.
    constexpr T density_ratio(const vec3<T>& m) const {
        const vec3<T> s = unstretch(m);
        const T k = a * dot(m, m) / dot(s, s);
        return k * k;
    }

private:
    T a;
};

/// The widths of an anisotropic distribution along the tangent and the bitangent.
/// Precondition: both > 0.
template <scalar T>
class alpha_xy {
public:
    using scalar = T;
    static constexpr bool isotropic = false;

    constexpr alpha_xy(const T& along_x, const T& along_y) : ax(along_x), ay(along_y) {
        assert(all(ax > T(0)));
        assert(all(ay > T(0)));
    }

    constexpr T x() const { return ax; }
    constexpr T y() const { return ay; }

    constexpr vec3<T> stretch(const vec3<T>& w) const { return {ax * w.x, ay * w.y, w.z}; }
    constexpr vec3<T> unstretch(const vec3<T>& m) const { return {m.x / ax, m.y / ay, m.z}; }

    /// (m.m)^2 / (ax ay ((x/ax)^2 + (y/ay)^2 + z^2)^2).
    constexpr T density_ratio(const vec3<T>& m) const {
        const vec3<T> s = unstretch(m);
        const T k = dot(m, m) / dot(s, s);
        return k * k / (ax * ay);
    }

private:
    T ax, ay;
};

}  // namespace lobe
