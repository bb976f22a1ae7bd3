// Beckmann's distribution: Gaussian slopes.
#pragma once

#include <lobe/ndf/radial.hpp>
#include <lobe/numeric/roots.hpp>
#include <lobe/numeric/special_functions.hpp>

namespace lobe {

/// Beckmann at alpha = 1: slopes with the density exp(-tau)/pi.
template <scalar T>
struct beckmann_shape {
    /// exp(-tau) sec2^2 / pi, as a square, so that nothing overflows on the way to the horizon.
    constexpr T D(const T& tau, const T& sec2) const {
        using std::exp;
        const T root = sec2 * exp(-tau / T(2));
        return root * root * inv_pi<T>();
    }

    constexpr T survival(const T& tau) const {
        using std::exp;
        return exp(-tau);
    }
    constexpr T tan2(const T& u) const {
        using std::log1p;
        return -log1p(-u);
    }

    /// (exp(-a^2)/sqrt(pi) - a erfc(a))/2; from a = 1e4 on it is below exp(-1e8).
    /// Beside the cosine, its cancellation does not show.
    constexpr T back(const T& cotangent) const {
        using std::erfc, std::exp, std::sqrt;
        const T a = smaller(cotangent, T(1e4f));
        return larger(exp(-a * a) / sqrt(pi<T>()) - a * erfc(a), T(0)) / T(2);
    }

    /// back(a)/a, from a = 4 on by 20 terms of the continued fraction
    /// erfc(a) = exp(-a^2)/sqrt(pi) / (a + (1/2)/(a + (2/2)/(a + ...))): with r_n = a r_(n+1) + (n+1)/2 r_(n+2),
    /// from its tail on, back(a) = exp(-a^2)/(4 sqrt(pi)) r_2/r_0, where nothing cancels.
    constexpr T lambda(const T& cotangent) const {
        using std::exp, std::sqrt;
        if constexpr (detail::beyond_double<T>) {
            return back(cotangent) / cotangent;
        } else {
            const T a = smaller(cotangent, T(30));  // exp(-900) is zero
            T r = a, before(1), r2(0);
            for (int n = 19; n >= 0; --n) {
                const T next = a * r + T(n + 1) / T(2) * before;
                before = r;
                r = next;
                if (n == 2) r2 = r;
            }
            return select(a < T(4), back(cotangent), exp(-a * a) / (T(4) * sqrt(pi<T>())) * (r2 / r)) / cotangent;
        }
    }

    /// Slopes along v's azimuth by inverse CDF, slopes across it Gaussian. Heitz & d'Eon 2014, "Importance Sampling
    /// Microfacet-Based BSDFs using the Distribution of Visible Normals"; Jakob 2014, "An Improved Visible Normal
    /// Sampling Routine for the Beckmann Distribution", whose equation this is times the cosine, so that it holds from
    /// the normal to below the horizon:  z (1 + erf x)/2 + s exp(-x^2)/(2 sqrt(pi)) = u.x sigma,  x < cot.
    /// Scalar types only. u.x = 0 and u.y = 0 give slopes of about 10 instead of infinite ones.
    constexpr vec3<T> sample_visible(const vec3<T>& w, const vec2<T>& u) const requires(detail::one_lane<T>) {
        using std::erfc, std::exp, std::sqrt;
        const vec3<T> v = normalize(w);
        const T z = v.z, s = sqrt(v.x * v.x + v.y * v.y), root_pi = sqrt(pi<T>()), last(9);
        const T top = z < last * s ? larger(z / s, -last) : last;
        const auto visible_below = [&](const T& x) { return (z * erfc(-x) + s * exp(-x * x) / root_pi) / T(2); };
        const T wanted = u.x * visible_below(top);
        const T x = detail::root_of_increasing<T>(-last, top, smaller(T(0), top), [&](const T& at) {
            return detail::value_and_slope<T>{visible_below(at) - wanted, (z - s * at) * exp(-at * at) / root_pi};
        });

        const T half = larger(smaller(u.y, T(1) - u.y), T(1e-35f));
        const T y = (u.y < T(1) / T(2) ? T(-1) : T(1)) * detail::inverse_half_erfc(half);
        const T ex = s > T(0) ? v.x / s : T(1), ey = s > T(0) ? v.y / s : T(0);
        return {-(x * ex - y * ey), -(x * ey + y * ex), T(1)};
    }

    template <scalar U>
    constexpr beckmann_shape<U> as() const {
        return {};
    }
};

/// Beckmann: D = exp(-tan^2/alpha^2) / (pi alpha^2 cos^4), isotropic from `alpha`, anisotropic from `alpha_xy`.
/// alpha = sqrt(2) times the rms slope. Beckmann & Spizzichino 1963; Cook & Torrance 1982; Walter et al. 2007, eq. 25;
/// Lambda: Heitz 2014, eq. 68.
/// Domain: alpha (of `alpha_xy` the product) from 1e-19 in float, 1e-150 in double, whose square is a number; any
/// direction. D in 1/sr; where it underflows it is zero.
/// Error of D: 12 (1 + |ln(D pi ax ay)|) ULP; of the projected area: 4 ULP; of Lambda in double:
/// relative 4e-14 for cot/alpha <= 8, in float 3e-5, zero where it underflows. Below the horizon the area
/// is a difference: relative 3e-7 (1 + cot^2/alpha^2)^2 in float, 1e-12 in double (docs/accuracy.md).
template <scalar T, detail::width_of<T> Width = alpha<T>>
class beckmann : public radial<beckmann_shape<T>, Width> {
public:
    constexpr explicit beckmann(const Width& width) : radial<beckmann_shape<T>, Width>({}, width) {}
};
template <class W>
beckmann(W) -> beckmann<detail::number_t<W>, detail::width_t<W>>;

/// Beckmann's slopes with Walter's rational back faces.
template <scalar T>
struct beckmann_walter_shape : beckmann_shape<T> {
    using approximate_area = void;
    constexpr T back(const T& a) const {
        const T last = T(8) / T(5), inside = smaller(a, last);
        const T fit = (T(1000) + inside * (T(396) * inside - T(1259))) / (T(3535) + T(2181) * inside);
        return select(a < last, fit, T(0));
    }
    constexpr T lambda(const T& a) const { return back(a) / a; }
    template <scalar U>
    constexpr beckmann_walter_shape<U> as() const {
        return {};
    }
};

/// Beckmann with the projected area of Walter et al. 2007,
/// p. 7: Lambda ~ (1 - 1.259 a + 0.396 a^2)/(3.535 a + 2.181 a^2) for a = cot/alpha < 1.6, else 0: no exponential
/// and no error function. G1 within 0.32 % of `beckmann`'s, with a jump of 6e-5 at 1.6; Lambda itself is off by up
/// to 92 % near 1.5. Sampling: all normals, as `beckmann`; visible normals would need the exact area.
template <scalar T, detail::width_of<T> Width = alpha<T>>
class beckmann_walter : public radial<beckmann_walter_shape<T>, Width> {
public:
    constexpr explicit beckmann_walter(const Width& width) : radial<beckmann_walter_shape<T>, Width>({}, width) {}
};
template <class W>
beckmann_walter(W) -> beckmann_walter<detail::number_t<W>, detail::width_t<W>>;

}  // namespace lobe
