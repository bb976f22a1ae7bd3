// Blinn's distribution, normalised, and the maps between its exponent and a width.
#pragma once

#include <lobe/ndf/student_t.hpp>

namespace lobe {

/// n = 2/alpha^2 - 2: the exponent whose peak is that of GGX and Beckmann of width alpha, 1/(pi alpha^2). Walter et al. 2007, p. 7;
/// Karis 2013. (The misprint 2 alpha^2 - 2 is normalised too, and grows towards the horizon.)
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

/// Blinn-Phong: D = (n + 2)/(2 pi) cos^n, n = 2/alpha^2 - 2. Blinn 1977, "Models of Light Reflection for Computer Synthesized
/// Pictures". Its slopes follow Student's t with gamma = 1/alpha^2 + 1 and the same alpha (put tan^2 = 1/cos^2 - 1 into
/// STD), so its projected area is closed after all, and that is how it is written. The family is not shape-invariant: only `alpha`.
/// Domain: 0 < alpha <= 1 (n >= 0). D in 1/sr. Projected area, Lambda, visible normals: scalar types only (0.2 microseconds an
/// area); `masked_by{blinn_phong{a}, beckmann{a}}` is the usual cheap stand-in (Walter et al. 2007). Error of D:
/// 10 (1 + |ln(D pi alpha^2 cos^4)|) ULP; of the projected area and of Lambda: those of `student_t`.
template <scalar T, detail::one_width_type Width = alpha<T>>
class blinn_phong : public radial<student_t_shape<T>, detail::width_in_t<Width, T>> {
public:
    constexpr explicit blinn_phong(const Width& width)
        : radial<student_t_shape<T>, Width>(student_t_shape<T>::from_k(inverse_square(width.x())), width) {}
    static constexpr blinn_phong from_exponent(const T& n) { return blinn_phong(alpha_from_blinn_phong_exponent(n)); }

private:
    static constexpr T inverse_square(const T& a) {
        assert(all(a <= T(1)) && "blinn_phong: alpha must be at most 1, an exponent at least 0");
        return T(1) / (a * a);
    }
};
template <class W>
blinn_phong(W) -> blinn_phong<detail::number_t<W>, detail::one_width_t<W>>;

}  // namespace lobe
