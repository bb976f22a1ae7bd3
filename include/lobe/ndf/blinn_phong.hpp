// Blinn's distribution, normalised.
#pragma once

#include <lobe/ndf/student_t.hpp>
#include <lobe/width/exponents.hpp>

namespace lobe {

/// Blinn-Phong: D = (n + 2)/(2 pi) cos^n, n = 2/alpha^2 - 2. Blinn 1977, "Models of Light Reflection
/// for Computer Synthesized Pictures". Its slopes follow Student's t with gamma = 1/alpha^2 + 1 and the same
/// alpha (put tan^2 = 1/cos^2 - 1 into STD), so its projected area is closed after all, and that is how it is written.
/// The family is not shape-invariant: only `alpha`.
/// Domain: 0 < alpha <= 1 (n >= 0). D in 1/sr. Projected area, Lambda, visible normals:
/// scalar types only (0.2 microseconds an area); `masked_by{blinn_phong{a}, beckmann{a}}` is the usual cheap
/// stand-in (Walter et al. 2007).
/// Error of D: 10 (1 + |ln(D pi alpha^2 cos^4)|) ULP; of the projected area and of Lambda: those of `student_t`.
template <scalar T, detail::one_width_of<T> Width = alpha<T>>
class blinn_phong : public radial<student_t_shape<T>, Width> {
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
