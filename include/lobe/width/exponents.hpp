// The exponents of Blinn-Phong and Phong, and the widths that they mean.
#pragma once

#include <lobe/width/alpha.hpp>

namespace lobe {

/// n = 2/alpha^2 - 2: the exponent whose peak is that of GGX and Beckmann of width alpha, 1/(pi alpha^2).
/// Walter et al. 2007, p. 7; Karis 2013. (The misprint 2 alpha^2 - 2 is normalised too, and grows towards the horizon.)
template <scalar T>
constexpr T blinn_phong_exponent_from_alpha(const alpha<T>& a) {
    return T(2) * (T(1) - a.value()) * (T(1) + a.value()) / (a.value() * a.value());
}

/// alpha = sqrt(2/(n + 2)), n > -2: its inverse.
template <scalar T>
constexpr alpha<T> alpha_from_blinn_phong_exponent(const T& n) {
    using std::sqrt;
    return alpha<T>(sqrt(T(2) / (n + T(2))));
}

/// The exponent of Blinn's n.h lobe that resembles Phong's r.v lobe of the exponent n: four times it, because the
/// half vector turns half as fast (Fisher & Woo 1994, "R.E versus N.H Specular Highlights"). Exact as n grows.
template <scalar T>
constexpr T blinn_phong_exponent_from_phong_exponent(const T& n) {
    return T(4) * n;
}

template <scalar T>
constexpr T phong_exponent_from_blinn_phong_exponent(const T& n) {
    return n / T(4);
}

/// Blinn's exponent from an artist's gloss s in [0,1]: largest^s, from 1 to `largest`.
template <scalar T>
constexpr T blinn_phong_exponent_from_gloss(const T& s, const T& largest) {
    using std::pow;
    return pow(largest, s);
}

/// n = (1/alpha^2 - 1)/2: the exponent of the r.v lobe that resembles Blinn-Phong of width alpha, whose n.h exponent is
/// four times it. Fisher & Woo 1994, "R.E versus N.H Specular Highlights".
template <scalar T>
constexpr T phong_exponent_from_alpha(const alpha<T>& a) {
    return (T(1) - a.value()) * (T(1) + a.value()) / (T(2) * a.value() * a.value());
}

/// alpha = 1/sqrt(2 n + 1), n >= 0: its inverse.
template <scalar T>
constexpr alpha<T> alpha_from_phong_exponent(const T& n) {
    using std::sqrt;
    return alpha<T>(T(1) / sqrt(T(2) * n + T(1)));
}

}  // namespace lobe
