// GGX's density for numbers of 16 bits, as shaders on phones have them.
#pragma once

#include <lobe/width/alpha.hpp>

namespace lobe {

/// D of isotropic GGX in binary16: 1 - (n.m)^2 written as |n x m|^2 (Lagrange's identity), here x^2 + y^2, as in the
/// mobile shaders of Filament and Unity, and grouped so that no term overflows, and none that counts loses
/// digits below 6.1e-5:
///   q = x (x/a) + y (y/a) + z (a z),  D = 1/(pi q^2),  computed on 8 m, which costs no rounding
/// `ggx<T>::D` squares x, y and a z by themselves. In binary16 that is as right for alpha from 1/128 on, but not where
/// subnormals are flushed to zero, as GPUs may do (5 % off at alpha 0.05), and infinite for alpha < 1/256.
/// Domain: unit m (16 bits keep it so to 5e-4); alpha in [0.0022, 1]. D in 1/sr, zero below the horizon.
/// Error: 13 roundings of 2^-11 at most, 0.64 %, and that of the subnormal itself where D < 6.1e-5. Where subnormals
/// are flushed 14, and 17 for alpha < 0.05: q loses what of it is below 6.1e-5.
/// `largest` is what a D that does not fit becomes: at the normal for alpha < 0.0022044 = 1/sqrt(65504 pi). Such a
/// highlight keeps the share 2 c - c^2 of its light, c = alpha/0.0022044: 0.99 at 0.002, 0.70 at 0.001, 0.09 at 1e-4.
/// No density of 16 bits keeps more.
template <scalar T>
constexpr T D_ggx_half(const vec3<T>& m, const alpha<T>& a, const T& largest = T(65504)) {
    const T x = T(8) * m.x, y = T(8) * m.y, z = T(8) * m.z;
    const T q = x * (x / a.value()) + y * (y / a.value()) + z * (a.value() * z);
    const T k = T(64) / q;
    return select(m.z < T(0), T(0), smaller(inv_pi<T>() * k * k, largest));
}

}  // namespace lobe
