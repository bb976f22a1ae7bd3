// Punctual lights, which reach a point from one direction, and the light that a BRDF makes of them.
#pragma once

#include <lobe/brdf/concepts.hpp>
#include <lobe/core/frame.hpp>

#include <cassert>

namespace lobe {

// The lights of glTF's KHR_lights_punctual (Khronos 2018), in its units; any space, as long as it is one:
//   directional_light   illuminance   lux     = lm/m^2     (or, radiometric, W/m^2)
//   point_light         intensity     candela = lm/sr      (W/sr), positions in metres
//   spot_light          intensity     candela inside the inner cone
// A light is called with a point and answers with what arrives there. S: one number or linear rgb.

/// GLM converts float and double vectors into each other silently. A light that derives from this, and `using`s
/// its operator, does not. (`Self`: see `exact_vectors`.)
template <class Self>
struct exact_points {
    template <class P>
    void operator()(const P&) const = delete;  // convert the point: vec3<T>(p), T the light's scalar
};

/// What arrives at a point: the unit direction `l` to the light, and the illuminance of a surface
/// that faces it, in lux.
template <class S, scalar T>
struct incident_light {
    vec3<T> l;
    S illuminance;
};

/// L = f(v,l) cos(theta_l) E: the reflectance equation of one light; no integral is left. v, light.l in tangent space.
/// Lux gives cd/m^2 (W/m^2 gives W/(m^2 sr)), so under E = 1 a white Lambertian surface shows 1/pi:
/// engines that want 1 there put the pi into their lights.
template <brdf B, class S, std::same_as<typename B::scalar> T>
constexpr auto reflected_radiance(const B& b, const vec3<T>& v, const incident_light<S, T>& light) {
    return b.f_cos(v, light.l) * light.illuminance;
}

/// The same with v and light.l in the space of the frame's vectors.
template <brdf B, class S, std::same_as<typename B::scalar> T>
constexpr auto reflected_radiance(const B& b, const frame<T>& at, const vec3<T>& v, const incident_light<S, T>& light) {
    return b.f_cos(at.to_local(v), at.to_local(light.l)) * light.illuminance;
}

/// So far away that it shines on all points alike. `to_light`: unit, from the surface to the light (glTF's node shines
/// along -z, so this is its +z).
template <class S, scalar T>
class directional_light : exact_points<directional_light<S, T>> {
public:
    using exact_points<directional_light>::operator();
    constexpr directional_light(const vec3<T>& to_light, const S& illuminance) : l(to_light), E(illuminance) {}

    constexpr incident_light<S, T> operator()(const vec3<T>&) const { return {l, E}; }

private:
    vec3<T> l;
    S E;
};

/// How intensity falls off, as a function of the squared distance: 1/d^2, as nature does.
struct inverse_square {
    template <scalar T>
    constexpr T operator()(const T& d2) const {
        return T(1) / d2;
    }
};

/// max(0, 1 - (d/range)^4)/d^2: nothing beyond `range`, so that a renderer can cull.
/// KHR_lights_punctual, "Range Property".
/// Precondition: range > 0.
/// Error: 8 ULP, the factor 1 - (d/range)^2 taken apart.
template <scalar T>
class inverse_square_within {
public:
    constexpr explicit inverse_square_within(const T& range) : inverse_range2() {
        assert(all(range > T(0)) && "inverse_square_within: the range must be above 0");
        inverse_range2 = T(1) / (range * range);
    }

    constexpr T operator()(const T& d2) const {
        const T x = d2 * inverse_range2;
        return larger((T(1) - x) * (T(1) + x), T(0)) / d2;
    }

private:
    T inverse_range2;
};

/// The same intensity in all directions: E = I falloff(d^2). A source of the luminous power P (lumen) has I = P/(4 pi).
/// Domain: every point but the light's own position.
template <class S, scalar T, class Falloff = inverse_square>
class point_light : exact_points<point_light<S, T, Falloff>> {
public:
    using exact_points<point_light>::operator();
    constexpr point_light(const vec3<T>& position, const S& intensity, const Falloff& falloff = {})
        : p(position), I_v(intensity), attenuation(falloff) {}

    constexpr incident_light<S, T> operator()(const vec3<T>& point) const {
        using std::sqrt;
        const vec3<T> d = p - point;
        const T d2 = dot(d, d);
        return {d / sqrt(d2), I_v * attenuation(d2)};
    }

private:
    vec3<T> p;
    S I_v;  // candela, as photometry writes it (a bare I is a macro of <complex.h>)
    [[no_unique_address]] Falloff attenuation;
};

/// The angular falloff of a spot: 1 up to `inner`, 0 from `outer`, in between t^2,
/// t = (cos - cos(outer))/(cos(inner) - cos(outer)). KHR_lights_punctual, "Inner and Outer Cone Angles"
/// (its listing bends cones with cos(inner) - cos(outer) < 0.001; this does not). Differences of cosines are written
/// as (1 - cos) = |a - w|^2/2 of unit vectors, which stays right for the narrowest beams. Angles from the axis in
/// radians; precondition: 0 <= inner <= outer <= pi/2, where pi/2 as a float has it, 4e-8 above, is pi/2 for every T.
/// Angles that are equal, or become so in T, make a hard edge: 1 within, 0 from `outer` on.
template <scalar T>
class cone {
public:
    constexpr cone(const T& inner, const T& outer) {
        using std::sin;
        [[maybe_unused]] constexpr float rounding = 0x1p-23f;  // house: of a float, in which files hold angles
        assert(all(inner >= T(0)) && all(inner <= outer) && all(outer <= pi<T>() / T(2) * (T(1) + T(rounding))) &&
               "cone: 0 <= inner <= outer <= pi/2");
        const T widest = pi<T>() / T(2), within = smaller(outer, widest);
        const T i = sin(smaller(inner, within) / T(2)), o = sin(within / T(2));
        inside = T(2) * i * i;
        inverse_width = T(1) / larger(T(2) * (o - i) * (o + i), detail::smallest<T>());
        outside = T(2) * o * o;
    }

    /// axis: unit, where the spot points; w: unit, from the spot to the point.
    constexpr T operator()(const vec3<T>& axis, const vec3<T>& w) const {
        const vec3<T> e = axis - w;
        const T t = smaller(larger((outside - dot(e, e) / T(2)) * inverse_width, T(0)), T(1));
        return t * t;
    }

    /// int falloff dw, in sr: a spot of the luminous power P (lumen) has I = P/solid_angle().
    /// 2 pi (1 - (2 cos(inner) + cos(outer))/3).
    constexpr T solid_angle() const { return T(2) * pi<T>() * (T(2) * inside + outside) / T(3); }

private:
    T inside, outside, inverse_width;  // 1 - cos(inner), 1 - cos(outer), 1/(cos(inner) - cos(outer))
};

/// A point light within a cone around `axis`, a unit vector that points where the light goes (glTF: the node's -z).
template <class S, scalar T, class Falloff = inverse_square>
class spot_light : exact_points<spot_light<S, T, Falloff>> {
public:
    using exact_points<spot_light>::operator();
    constexpr spot_light(const vec3<T>& position, const vec3<T>& axis, const S& intensity, const cone<T>& angles,
                         const Falloff& falloff = {})
        : a(axis), bulb(position, intensity, falloff), shade(angles) {}

    constexpr incident_light<S, T> operator()(const vec3<T>& point) const {
        const incident_light<S, T> light = bulb(point);
        return {light.l, light.illuminance * shade(a, -light.l)};
    }

private:
    vec3<T> a;
    point_light<S, T, Falloff> bulb;
    cone<T> shade;
};

}  // namespace lobe
