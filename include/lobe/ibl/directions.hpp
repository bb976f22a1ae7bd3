// The sphere of directions on a lat-long map and on the faces of a cube, with exact solid angles.
#pragma once

#include <lobe/core/spectrum.hpp>
#include <lobe/core/vector.hpp>
#include <lobe/sampling/warp.hpp>

namespace lobe {

// Lat-long (equirectangular) maps, y up: u = 1/2 + atan2(z, x)/(2 pi) runs around the equator, v = acos(y)/pi from the
// zenith (v = 0) to the nadir (v = 1). The middle of the picture looks along +x.

/// Unit direction to (u, v): u in [0,1), v in [0,1], 1 at the nadir.
template <scalar T>
constexpr vec2<T> latlong_uv(const vec3<T>& direction) {
    using std::atan2, std::sqrt;
    const T rho = sqrt(direction.x * direction.x + direction.z * direction.z);
    const T v = atan2(rho, direction.y) * inv_pi<T>();  // acos(y), at full accuracy near the poles
    const T u = T(0.5) + atan2(direction.z, direction.x) * (inv_pi<T>() / T(2));
    return {select(u < T(1), u, T(0)), v};
}

/// (u, v) to the unit direction; v in [0,1], any u in [0,1].
template <scalar T>
constexpr vec3<T> latlong_direction(const vec2<T>& uv) {
    const auto [sin_phi, cos_phi] = sincos_2pi(uv.x);
    const auto [sin_theta, cos_theta] = sincos_2pi(uv.y / T(2));
    return {-sin_theta * cos_phi, cos_theta, -sin_theta * sin_phi};  // phi counts from the map's left edge, at -x
}

/// The exact solid angle of a texel in row `row` of a width x height map, in sr:
/// (2 pi/width) (cos theta_top - cos theta_bottom) = (4 pi/width) sin(theta_mid) sin(pi/(2 height)). They add up to 4
/// pi.
template <scalar T>
constexpr T latlong_texel_solid_angle(int row, int width, int height) {
    const T middle = (T(row) + T(0.5)) / T(height);
    return T(4) * pi<T>() / T(width) * sincos_2pi(middle / T(2)).sin * sincos_2pi(T(0.25) / T(height)).sin;
}

// Cube maps as OpenGL, Vulkan and Direct3D have them: faces +x, -x, +y, -y, +z, -z, (u, v) from the upper left corner
// of each, seen from inside: OpenGL 4.6 specification, table 8.19.

/// A face from 0 to 5, and (u, v) on it, both in [0,1].
template <scalar T>
struct cube_place {
    int face;
    vec2<T> uv;
};

/// The direction to (u, v) of a face, not normalised: its largest component is 1.
template <scalar T>
constexpr vec3<T> cube_point(int face, const vec2<T>& uv) {
    const T a = T(2) * uv.x - T(1), b = T(2) * uv.y - T(1), one(1);
    switch (face) {
        case 0: return {one, -b, -a};
        case 1: return {-one, -b, a};
        case 2: return {a, one, b};
        case 3: return {a, -one, -b};
        case 4: return {a, -b, one};
        default: return {-a, -b, -one};
    }
}

/// The same, normalised.
template <scalar T>
constexpr vec3<T> cube_direction(int face, const vec2<T>& uv) {
    return normalize(cube_point(face, uv));
}

/// Face and (u, v) of a direction of any length above 0. Scalar types only.
template <scalar T>
constexpr cube_place<T> cube_uv(const vec3<T>& w) {
    const T x = absolute(w.x), y = absolute(w.y), z = absolute(w.z);
    const auto place = [](int face, const T& a, const T& b, const T& size) {
        const T half = T(0.5f) / size;
        return cube_place<T>{face, {T(0.5f) + a * half, T(0.5f) + b * half}};
    };
    if (x >= y && x >= z) return w.x < T(0) ? place(1, w.z, -w.y, x) : place(0, -w.z, -w.y, x);
    if (y >= z) return w.y < T(0) ? place(3, w.x, -w.z, y) : place(2, w.x, w.z, y);
    return w.z < T(0) ? place(5, -w.x, -w.y, z) : place(4, w.x, -w.y, z);
}

/// The exact solid angle of a texel of a face of size x size, in sr: the sum over its corners, with their signs, of
/// atan2(x y, sqrt(x^2 + y^2 + 1)), x, y in [-1,1]. All of a cube add up to 4 pi. In double for float, where the sum
/// cancels.
template <scalar T>
T cube_texel_solid_angle(int column, int row, int size) {
    using W = detail::wide_t<T>;
    const auto corner = [&](int i, int j) {
        using std::atan2, std::sqrt;
        const W x = W(2 * i - size) / W(size), y = W(2 * j - size) / W(size);
        return W(atan2(x * y, sqrt(x * x + y * y + W(1))));
    };
    return T(corner(column + 1, row + 1) - corner(column, row + 1) - corner(column + 1, row) + corner(column, row));
}

}  // namespace lobe
