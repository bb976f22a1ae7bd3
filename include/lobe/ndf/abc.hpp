// The ABC distribution.
#pragma once

#include <lobe/ndf/radial.hpp>
#include <lobe/numeric/roots.hpp>
#include <lobe/numeric/special_functions.hpp>

#include <cassert>

namespace lobe {

/// ABC, its slopes divided by alpha. With y = 1 + B x, x = 1 - cos(theta), the normals below x have the share
/// int_1^y (B + 1 - y) y^-C dy over the same up to 1 + B: two integrals of powers, each l y0^s phi(s l), l = ln(y/y0).
template <scalar T>
class abc_shape {
public:
    constexpr abc_shape(const T& width, const T& exponent)
        : a2(width * width), C(exponent), B(T(2) / a2), whole(), norm() {
        using W = detail::at_least_double<T>;
        using std::log1p;
        assert(all(width > T(0)) && "abc: alpha must be above 0");
        assert(all(C >= T(0)) && "abc: C must not be negative");
        const W wide_B = W(2) / (W(width) * W(width));
        whole = T(moment(wide_B, W(C), W(0), W(log1p(wide_B))));  // for alpha > 1 a difference of near equals
        norm = T(2) / (a2 * whole) * inv_pi<T>();
    }

    constexpr T D(const T& tau, const T& sec2) const {
        using std::exp;
        const T ratio = sec2 / (T(1) + a2 * tau);
        return norm * ratio * ratio * exp(-C * log_y(tau));
    }

    constexpr T survival(const T& tau) const {
        using std::log1p;
        const T from = log_y(tau);
        return moment(B, C, from, larger(log1p(B) - from, T(0))) / whole;
    }

    /// Newton's method on ln y. Scalar types only.
    constexpr T tan2(const T& u) const requires(detail::one_lane<T>) {
        using W = detail::at_least_double<T>;
        if constexpr (!std::same_as<W, T>) {
            return T(as<W>().tan2(W(u)));
        } else {
            using std::exp, std::expm1, std::log1p;
            const T guess = C > T(1.5) ? -log1p(-u) / (C - T(1)) : -log1p(-u) * T(2);
            const T l = detail::root_of_increasing<T>(T(0), log1p(B), guess, [&](const T& at) {
                const T left = B - expm1(at);
                return detail::value_and_slope<T>{moment(B, C, T(0), at) / whole - u,
                                                  left * exp((T(1) - C) * at) / whole};
            });
            const T x = smaller(expm1(l) / B, T(1) - std::numeric_limits<T>::epsilon()), c = T(1) - x;
            return expm1(l) / T(2) * (T(2) - x) / (c * c);
        }
    }

    template <scalar U>
    constexpr abc_shape<U> as() const {
        using std::sqrt;
        return abc_shape<U>(sqrt(U(a2)), U(C));
    }

private:
    /// ln(1 + B x), 1 - cos = tan^2/(1 + tan^2 + sqrt(1 + tan^2)).
    constexpr T log_y(const T& tau) const {
        using std::log1p, std::sqrt;
        const T sec2 = T(1) + a2 * tau;
        return log1p(T(2) * (tau / (sec2 + sqrt(sec2))));
    }

    /// int (B + 1 - y) y^-C dy from y = e^from over a range of l in ln y.
    template <scalar U>
    static constexpr U moment(const U& B, const U& C, const U& from, const U& l) {
        using std::exp;
        return l * exp((U(1) - C) * from) *
               ((B + U(1)) * detail::expm1_ratio((U(1) - C) * l) - exp(from) * detail::expm1_ratio((U(2) - C) * l));
    }

    T a2, C, B, whole, norm;
};

/// ABC: D = A / (1 + B (1 - cos theta_m))^C, B = 2/alpha^2, A from normalisation.
/// Low, Kronander, Ynnerman & Unger 2012, "BRDF Models for Accurate and Efficient Rendering of Glossy Surfaces",
/// eq. 12; the spectrum of polished surfaces of Church 1989. Near the normal it is (1 + theta^2/alpha^2)^-C,
/// as GGX is at C = 2. Not shape-invariant: only `alpha`.
/// Domain: alpha > 0, C >= 0. D in 1/sr. Sampling: scalar types only. No closed projected area:
/// `tabulated` or `masked_by`.
/// Error of D: 12 (1 + |ln(D pi alpha^2)|) ULP, in double for alpha > 3 up to alpha^2/10 times that;
/// of the projected area: 3e-6 of that along the horizon, at alpha = 1e-4, where it is largest, 4e-5 for C < 1.
template <scalar T, detail::one_width_of<T> Width = alpha<T>>
class abc : public radial<abc_shape<T>, Width> {
public:
    constexpr abc(const Width& width, const T& C) : radial<abc_shape<T>, Width>(abc_shape<T>(width.x(), C), width) {}
    /// From the B and C of the paper, whose A follows.
    static constexpr abc from_b(const T& B, const T& C) {
        using std::sqrt;
        return {alpha<T>(sqrt(T(2) / B)), C};
    }
};
template <class W, class P>
abc(W, P) -> abc<detail::number_t<W, P>, detail::one_width_t<W, P>>;

}  // namespace lobe
