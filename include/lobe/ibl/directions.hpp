// The sphere of directions on a lat-long map, with exact solid angles.
#pragma once

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

}  // namespace lobe
