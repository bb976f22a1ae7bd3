// Diffuse light from an environment.
#pragma once

#include <lobe/core/frame.hpp>
#include <lobe/core/spectrum.hpp>
#include <lobe/ibl/latlong.hpp>
#include <lobe/sampling/points.hpp>
#include <lobe/sampling/warp.hpp>

#include <cassert>
#include <limits>
#include <type_traits>
#include <vector>

namespace lobe {

/// Irradiance/pi at the normal n: the mean radiance over the hemisphere, weighted with the cosine, which is what a
/// white Lambertian surface sends back, and what irradiance maps store. Multiply by pi for the irradiance.
/// `environment`: any callable from a unit world direction to a radiance. n: unit, world space.
/// Error: that of `count` >= 1 cosine-distributed Hammersley points; none for a constant environment.
template <scalar T, class Environment>
constexpr auto irradiance(const Environment& environment, const vec3<T>& n, std::uint32_t count) {
    using S = std::decay_t<decltype(environment(n))>;
    using WS = detail::wide_t<S>;
    using W = detail::wide_t<T>;
    assert(count > 0 && "irradiance: count must be above 0");
    const frame<T> at(n);
    WS total(W(0));
    for (std::uint32_t i = 0; i < count; ++i)
        total = total + WS(environment(at.to_world(square_to_cosine_hemisphere(hammersley<T>(i, count)))));
    return S(total * (W(1) / W(count)));
}

/// The same from every texel of a lat-long image, with its solid angle: no sun is missed. Texels of images coarser than
/// 128 x 64 are cut into parts until the parts are as small. Cost: width x height, at least 8192 parts, a normal.
/// Error: of the midpoint rule over the parts, 2e-4 of the brightest texel; none for a constant image.
template <scalar T>
vec3<T> irradiance(const latlong<T>& environment, const vec3<T>& n) {
    using W = detail::wide_t<T>;
    const int width = environment.width, across = (128 + width - 1) / width,
              down = (64 + environment.height - 1) / environment.height;
    // The directions of the first parts of all columns, then of the second ones, ...; those of a row are these, tilted
    // by v.
    std::vector<vec3<T>> equator;
    for (int part = 0; part < across; ++part)
        for (int column = 0; column < width; ++column)
            equator.push_back(
                latlong_direction(vec2<T>{(T(column * across + part) + T(0.5)) / T(width * across), T(0.5)}));
    vec3<W> total(W(0));
    W weights(0);
    for (int row = 0; row < environment.height * down; ++row) {
        const auto [sin_theta, cos_theta] = sincos_2pi((T(row) + T(0.5)) / T(2 * environment.height * down));
        const T solid_angle = latlong_texel_solid_angle<T>(row, width * across, environment.height * down);
        const vec3<T>* e = equator.data();
        for (int part = 0; part < across; ++part)
            for (int column = 0; column < width; ++column, ++e) {
                const T weight = larger(sin_theta * (e->x * n.x + e->z * n.z) + cos_theta * n.y, T(0)) * solid_angle;
                total += vec3<W>(environment.at(column, row / down)) * W(weight);
                weights += W(weight);
            }
    }
    // no direction is above n: it is one of NaNs
    if (!(weights > W(0))) return vec3<T>(std::numeric_limits<T>::quiet_NaN());
    return vec3<T>(total / weights);  // not by pi: a constant environment comes back as it is
}

}  // namespace lobe
