// The exponential power distribution of slopes: Beckmann with another exponent.
#pragma once

#include <lobe/ndf/radial.hpp>
#include <lobe/numeric/roots.hpp>
#include <lobe/numeric/special_functions.hpp>

#include <cassert>

namespace lobe {

/// EPD at alpha = 1: slopes with the density exp(-tau^p) / (pi Gamma(1 + 1/p)).
template <scalar T>
class exponential_power_shape {
public:
    constexpr explicit exponential_power_shape(const T& exponent) : p(exponent), norm(inv_pi<T>()) {
        using std::tgamma;
        assert(all(p > T(0)) && all(p <= T(50)) && "exponential_power: p must be in (0, 50]");
        norm = inv_pi<T>() / tgamma(T(1) + T(1) / p);
    }

    constexpr T D(const T& tau, const T& sec2) const {
        using std::exp, std::pow;
        const T root = sec2 * exp(-pow(tau, p) / T(2));
        return root * root * norm;
    }

    /// Q(1/p, tau^p), the regularised incomplete gamma function. Scalar types only, as its inverse.
    constexpr T survival(const T& tau) const requires(detail::one_lane<T>) {
        using std::pow;
        return detail::incomplete_gamma<T>(T(1) / p).upper(pow(tau, p));
    }
    constexpr T tan2(const T& u) const requires(detail::one_lane<T>) {
        using W = detail::at_least_double<T>;
        using std::exp, std::log, std::log1p;
        if (!(u > T(0))) return T(0);
        // Newton in y = ln(tau^p), on the logarithm of whichever tail is the smaller: there both are concave
        const W s = W(1) / W(p);
        const detail::incomplete_gamma<W> of(s);
        const bool low = u < T(1) / T(2);
        const W wanted = low ? log(W(u)) : log1p(-W(u));
        const auto excess = [&](const W& y) {
            const W x = exp(y), share = low ? of.lower(x) : of.upper(x);
            if (!(share > W(0))) return detail::value_and_slope<W>{low ? W(-1) : W(1), W(0)};
            return detail::value_and_slope<W>{low ? log(share) - wanted : wanted - log(share), of.front(x) / share};
        };
        // lower(x) is at most x^s/Gamma(s + 1), and close to it for small x: a bound from below,
        // and where the search starts in that tail
        const W least = log(W(u) * of.gamma_s * s) / s;
        if (exp(least) < std::numeric_limits<W>::epsilon()) return T(exp(least * s));
        return T(exp(detail::root_of_increasing<W>(least - W(1), W(7), low ? least : log(s + W(1)), excess) * s));
    }

    /// Beyond it exp(-tau^p) < 1e-26.
    constexpr T max_tan2() const {
        using std::pow;
        return pow(T(60), T(1) / p);
    }

    template <scalar U>
    constexpr exponential_power_shape<U> as() const {
        return exponential_power_shape<U>(U(p));
    }

private:
    T p, norm;
};

/// EPD, or generalised Beckmann: D = exp(-(tan^2/alpha^2)^p) / (pi alpha^2 Gamma(1 + 1/p) cos^4), isotropic from
/// `alpha`, anisotropic from `alpha_xy`. Holzschuch & Pacanowski 2017, "A Two-Scale Microfacet Reflectance Model
/// Combining Reflection and Diffraction"; Hoffman 2016. p = 1 is Beckmann. Some sources write 2p or p/2 for this p.
/// Domain: alpha as `beckmann`, p in (0, 50] (areas tested from 1/4 to 4). D in 1/sr. Sampling: scalar types only. No
/// closed projected area: `tabulated`, whose table `shared` lends to every width, or `masked_by`.
/// Error of D: 6 max(1, p) (1 + (tan^2/alpha^2)^p) ULP; of the projected area: 4e-6 of that along the horizon.
template <scalar T, detail::width_of<T> Width = alpha<T>>
class exponential_power : public radial<exponential_power_shape<T>, Width> {
public:
    constexpr exponential_power(const Width& width, const T& p)
        : radial<exponential_power_shape<T>, Width>(exponential_power_shape<T>(p), width) {}
};
template <class W, class P>
exponential_power(W, P) -> exponential_power<detail::number_t<W, P>, detail::width_t<W, P>>;

}  // namespace lobe
