// SGD, the shifted gamma distribution.
#pragma once

#include <lobe/ndf/radial.hpp>
#include <lobe/numeric/roots.hpp>
#include <lobe/numeric/special_functions.hpp>

#include <cassert>

namespace lobe {

/// SGD, its slopes divided by alpha: slopes with the density exp(-alpha tau) (1 + tau)^-p / (pi G),
/// G = e^alpha alpha^(p-1) Gamma(1-p, alpha). Scalar types only.
template <scalar T>
class sgd_shape {
public:
    constexpr sgd_shape(const T& width, const T& exponent) : a(width), p(exponent), whole(), norm() {
        using W = detail::at_least_double<T>;
        using std::exp, std::pow;
        assert(all(a > T(0)) && all(a <= T(100)) && "sgd: alpha must be in (0, 100]");
        assert(all(p >= T(0)) && all(p <= T(50)) && "sgd: p must be in [0, 50]");
        const W gamma = detail::upper_gamma<W>(W(1) - W(p), W(a));
        whole = T(gamma);
        norm = inv_pi<T>() / T(gamma * exp(W(a)) * pow(W(a), W(p) - W(1)));
    }

    constexpr T D(const T& tau, const T& sec2) const {
        using std::exp, std::pow;
        const T root = sec2 * exp(-a * tau / T(2)) * pow(T(1) + tau, -p / T(2));
        return root * root * norm;
    }

    constexpr T survival(const T& tau) const { return detail::upper_gamma<T>(T(1) - p, a * (T(1) + tau)) / whole; }

    /// Newton's method on the logarithm of the survival, in ln(1 + tau).
    constexpr T tan2(const T& u) const {
        using W = detail::at_least_double<T>;
        if constexpr (!std::same_as<W, T>) {
            return T(as<W>().tan2(W(u)));
        } else {
            using std::exp, std::expm1, std::log, std::log1p;
            const T wanted = -log1p(-u), most = log1p(T(80) / a);
            return expm1(detail::root_of_increasing<T>(T(0), most, smaller(wanted / (a + p), most), [&](const T& y) {
                const T tau = expm1(y), left = survival(tau);
                if (!(left > T(0))) return detail::value_and_slope<T>{T(1), T(0)};
                return detail::value_and_slope<T>{-log(left) - wanted, D(tau, T(1)) * pi<T>() * exp(y) / left};
            }));
        }
    }

    /// Beyond it exp(-alpha tau) < 1e-26.
    constexpr T max_tan2() const { return T(60) / a; }

    template <scalar U>
    constexpr sgd_shape<U> as() const {
        return sgd_shape<U>(U(a), U(p));
    }

private:
    T a, p, whole, norm;
};

/// SGD: D = P(tan^2 theta_m) / (pi cos^4), P(x) = alpha^(p-1)/Gamma(1-p, alpha)
/// exp(-(alpha^2 + x)/alpha) / (alpha^2 + x)^p. Bagher, Soler & Holzschuch 2012, "Accurate fitting
/// of measured reflectances using a Shifted Gamma micro-facet distribution", whose alpha and p these are.
/// Not shape-invariant: only `alpha`. p = 0 is Beckmann of width sqrt(alpha).
/// Domain: alpha in (0, 100], p in [0, 50]: the constants of D have to fit into a double. D in 1/sr. Scalar types only;
/// making one takes 1 to 3 microseconds, for Gamma(1-p, alpha). No closed projected area: `tabulated` or `masked_by`.
/// Error of D for alpha <= 1, p <= 9: 10 (1 + |ln(D pi alpha^2)|) ULP, in double relative 1e-14
/// (that of Gamma(1-p, alpha)) more; of the projected area: 3e-6 of that along the horizon for p <= 4,
/// and at alpha = 1e-4, where it is largest, 3e-5 for p = 9.
template <scalar T, detail::one_width_of<T> Width = alpha<T>>
class sgd : public radial<sgd_shape<T>, Width> {
public:
    constexpr sgd(const Width& width, const T& p) : radial<sgd_shape<T>, Width>(sgd_shape<T>(width.x(), p), width) {}
};
template <class W, class P>
sgd(W, P) -> sgd<detail::number_t<W, P>, detail::one_width_t<W, P>>;

}  // namespace lobe
