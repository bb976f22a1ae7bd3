// Reflectances of common materials, linear rgb, and the optical constants of metals.
#pragma once

#include <lobe/fresnel/conductor.hpp>

namespace lobe::materials {

namespace detail {

template <scalar T>
constexpr vec3<T> rgb(double red, double green, double blue) {
    return {lobe::detail::constant<T>(red), lobe::detail::constant<T>(green), lobe::detail::constant<T>(blue)};
}

}  // namespace detail

/// F0 in linear rgb, for `schlick` and its kin: `schlick{materials::F0::gold<float>()}`.
/// Akenine-Moller, Haines & Hoffman 2008, "Real-Time Rendering", third edition, two decimals.
namespace F0 {

template <scalar T>
constexpr vec3<T> water() {
    return detail::rgb<T>(0.02, 0.02, 0.02);
}
template <scalar T>
constexpr vec3<T> plastic_low() {
    return detail::rgb<T>(0.03, 0.03, 0.03);
}  // and glass, low
template <scalar T>
constexpr vec3<T> plastic_high() {
    return detail::rgb<T>(0.05, 0.05, 0.05);
}
template <scalar T>
constexpr vec3<T> glass_high() {
    return detail::rgb<T>(0.08, 0.08, 0.08);
}  // and ruby
template <scalar T>
constexpr vec3<T> diamond() {
    return detail::rgb<T>(0.17, 0.17, 0.17);
}

template <scalar T>
constexpr vec3<T> gold() {
    return detail::rgb<T>(1.00, 0.71, 0.29);
}
template <scalar T>
constexpr vec3<T> silver() {
    return detail::rgb<T>(0.95, 0.93, 0.88);
}
template <scalar T>
constexpr vec3<T> copper() {
    return detail::rgb<T>(0.95, 0.64, 0.54);
}
template <scalar T>
constexpr vec3<T> iron() {
    return detail::rgb<T>(0.56, 0.57, 0.58);
}
template <scalar T>
constexpr vec3<T> aluminium() {
    return detail::rgb<T>(0.91, 0.92, 0.92);
}

}  // namespace F0

// Metals in air as `conductor`s: eta and k measured at three wavelengths, for red, green and blue. The rows nearest
// to 650, 550 and 450 nm of the published tables, not interpolated (as digitised by refractiveindex.info, CC0).
// Three wavelengths are not a colour: F0 above is the spectrum seen through colour matching,
// and these differ from it by up to 0.12 (gold's blue), 0.10, 0.02, 0.08 and 0.006 in the order below.
// Spectral renderers take eta and k at their own wavelengths.

/// Johnson & Christy 1972, "Optical constants of the noble metals", Phys. Rev. B 6, 4370: 659.5, 548.6, 450.9 nm.
template <scalar T>
constexpr conductor<vec3<T>> gold() {
    return {detail::rgb<T>(0.14, 0.43, 1.38), detail::rgb<T>(3.697, 2.455, 1.914)};
}
/// As gold. The table has eta to two decimals, for silver one digit: F0 is known to 0.003.
template <scalar T>
constexpr conductor<vec3<T>> silver() {
    return {detail::rgb<T>(0.05, 0.06, 0.04), detail::rgb<T>(4.483, 3.586, 2.657)};
}
/// As gold.
template <scalar T>
constexpr conductor<vec3<T>> copper() {
    return {detail::rgb<T>(0.22, 1.02, 1.24), detail::rgb<T>(3.747, 2.577, 2.397)};
}
/// Johnson & Christy 1974, "Optical constants of transition metals: Ti, V, Cr, Mn, Fe, Co, Ni, and Pd", Phys. Rev.
/// B 9, 5056: 659, 549, 451 nm.
template <scalar T>
constexpr conductor<vec3<T>> iron() {
    return {detail::rgb<T>(2.92, 2.95, 2.59), detail::rgb<T>(3.10, 2.93, 2.77)};
}
/// Rakic 1995, "Algorithm for the determination of intrinsic optical constants of metal films: application to
/// aluminum", Appl. Opt. 34, 4755: 652.25, 563.57, 442.80 nm.
template <scalar T>
constexpr conductor<vec3<T>> aluminium() {
    return {detail::rgb<T>(1.5724, 1.0728, 0.6079), detail::rgb<T>(7.7354, 6.7839, 5.3676)};
}

}  // namespace lobe::materials
