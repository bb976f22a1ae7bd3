// Rough diffuse surfaces as fields of Lambertian facets: Oren and Nayar's model of 1994, and Fujii's improvement (FON).
#pragma once

#include <lobe/brdf/diffuse.hpp>

namespace lobe {

namespace detail {

/// sin(alpha) tan(beta) cos(phi_v - phi_l) = s / max(cos(theta_v), cos(theta_l)), s = v.l - cos(theta_v) cos(theta_l):
/// the dot product of the horizontal parts, which needs no angle.
template <scalar T>
constexpr T horizontal_dot(const vec3<T>& v, const vec3<T>& l) {
    return v.x * l.x + v.y * l.y;
}

}  // namespace detail

/// f = rho/pi (A + B max(0, s)/max(cos(theta_v), cos(theta_l))), A = 1 - sigma^2/(2 (sigma^2 + 0.33)),
/// B = 0.45 sigma^2/(sigma^2 + 0.09). Oren & Nayar 1994, "Generalization of Lambert's Reflectance Model",
/// the qualitative model (no interreflections).
/// sigma: standard deviation of the facets' slope angle, radians, in [0, pi/2]; rho in [0,1].
/// Albedo at rho = 1: from 0.559 (sigma = pi/2, seen from above) to 1.015 (sigma = 0.2, grazing):
/// it loses energy, or gains a little.
/// Rounding: 8 ULP of its largest term, B (|v.x l.x| + |v.y l.y|)/max(cos) among them.
/// Sampled by `backscatter_sampling`: weight at most 1.06 rho. `oren_nayar{rho, sigma, cosine_sampling{}}`:
/// 0.44 rho/cos(theta_v).
template <class S, class Sampler = backscatter_sampling>
class oren_nayar : public diffuse_brdf<oren_nayar<S, Sampler>, S, Sampler> {
    using T = component_t<S>;

public:
    constexpr oren_nayar(const S& albedo, const T& sigma, const Sampler& = {})
        : rho(albedo), A(T(1) - sigma * sigma / (T(2) * (sigma * sigma + T(33) / T(100)))),
          B(T(9) / T(20) * sigma * sigma / (sigma * sigma + T(9) / T(100))) {
        assert(detail::in_unit_interval(rho) && "oren_nayar: the albedo must be in [0,1]");
        assert(all(sigma >= T(0)) && all(sigma <= pi<T>() / T(2)) && "oren_nayar: sigma must be in [0,pi/2] radian");
    }

    /// Where s < 0, f is flat: the tilt of least variance is a compromise.
    constexpr backscatter<T> backscattered() const { return {B / (T(3) * A), B / A}; }

private:
    friend diffuse_brdf<oren_nayar, S, Sampler>;

    template <class Mask>
    constexpr S pi_f(const vec3<T>& v, const vec3<T>& l, const Mask& lit, const T& factor) const {
        const T s = detail::horizontal_dot(v, l);
        return rho * select(lit, (A + quotient(lit, B * larger(s, T(0)), larger(v.z, l.z))) * factor, T(0));
    }

    S rho;
    T A, B;
};

namespace detail {

/// FON's constants and its f over rho/pi: shared with EON.
template <scalar T>
struct fujii {
    T r, A;  // A = A_F

    static constexpr T c1() { return T(1) / T(2) - T(2) / T(3) * inv_pi<T>(); }
    static constexpr T c2() { return T(2) / T(3) - T(28) / T(15) * inv_pi<T>(); }

    constexpr explicit fujii(const T& roughness) : r(roughness), A(T(1) / (T(1) + c1() * roughness)) {
        assert(in_unit_interval(roughness) && "fon, eon: roughness must be in [0,1]");
    }

    constexpr T operator()(const vec3<T>& v, const vec3<T>& l) const {
        // no 1/0 below it, where nothing is asked for
        const T s = horizontal_dot(v, l), t = larger(larger(v.z, l.z), horizon<T>());
        // never negative by rounding, where 1 + r s vanishes
        return A * larger(T(1) + r * s / select(s > T(0), t, T(1)), T(0));
    }

    constexpr T B() const { return r * A; }
    constexpr T average_albedo() const { return A + B() * c2(); }

    /// 1 + tilt s must not vanish, as 1 + r s does: EON keeps some light there.
    constexpr backscatter<T> backscattered() const { return {r * (T(9) / T(10)), r}; }
};

}  // namespace detail

/// What a FON surface of albedo 1 fails to reflect: 1 - E_F(w) = r A_F loss(w), with loss = c1 - G/pi in the symbols
/// of Portsmouth, Kutz, Hill 2024 (listing 1, `E_FON_exact`), G = S (theta - S mu) + 2/3 ((S/mu) (1 - S^3) - S),
/// S = sin(theta), mu = cos(theta). Here as
///   loss = ( S asin(mu) + mu ( (pi/2 - 2/3) mu/(1+S) + S^2 - 2/3 S (1+S+S^2)/(1+S) ) ) / pi,
/// in which the constants that cancel at grazing, where loss is mu/pi, have cancelled already.
/// Domain: unit w, above the horizon.
/// Error: 8 ULP.
struct fon_loss {
    template <scalar T>
    constexpr T operator()(const vec3<T>& w) const {
        using std::atan2, std::sqrt;
        const T mu = w.z, S = sqrt(w.x * w.x + w.y * w.y), p = T(1) / (T(1) + S);
        const T bracket = (pi<T>() / T(2) - T(2) / T(3)) * mu * p + S * (S - T(2) / T(3) * (T(1) + S * S * p));
        return (S * atan2(mu, S) + mu * bracket) * inv_pi<T>();
    }
};

/// The same without an inverse tangent: G/pi as a polynomial of degree 4 in 1 - mu (ibid., `E_FON_approx`). At grazing
/// the polynomial exceeds c1 by 4.6e-4, which would be negative light; there loss is 0 (the paper's listing: 1e-7).
/// Error: 6.1e-4 against `fon_loss`, 4.7e-4 in E_F. EON with it is a loop that vectorises, some 50 times faster.
struct fon_loss_fit {
    template <scalar T>
    constexpr T operator()(const vec3<T>& w) const {
        const auto c = [](double x) { return T(static_cast<lane_t<T>>(x)); };
        const T m = T(1) - w.z;
        const T G = m * (c(0.0571085289) + m * (c(0.491881867) + m * (c(-0.332181442) + m * c(0.0714429953))));
        return larger(detail::fujii<T>::c1() - G, T(0));
    }
};

/// f = rho A_F/pi (1 + r s/t), t = max(cos(theta_v), cos(theta_l)) where s > 0,
/// else 1; A_F = 1/(1 + (1/2 - 2/(3 pi)) r). Fujii 2012, "A tiny improvement of Oren-Nayar reflectance model";
/// "FON" in Portsmouth, Kutz, Hill 2024. rho, r in [0,1]. E(mu) is `albedo(w)`,
/// its average rho A_F (1 + (2/3 - 28/(15 pi)) r): below 1, and 1 at grazing.
/// Rounding: 8 ULP of its largest term (1 + r s vanishes where r = 1 and both directions are grazing and opposite).
/// Sampled by `backscatter_sampling`: weight at most 1.04 rho. `fon{rho, r, cosine_sampling{}}`: 0.78 rho/cos(theta_v).
template <class S, class Sampler = backscatter_sampling>
class fon : public diffuse_brdf<fon<S, Sampler>, S, Sampler> {
    using T = component_t<S>;

public:
    constexpr fon(const S& albedo, const T& roughness, const Sampler& = {}) : rho(albedo), facets(roughness) {
        assert(detail::in_unit_interval(rho) && "fon: the albedo must be in [0,1]");
    }

    /// E(w) = rho (1 - r A_F loss(w)), in closed form; unit w above the horizon.
    template <class Loss = fon_loss>
    constexpr S albedo(const vec3<T>& w, const Loss& loss = {}) const {
        return rho * (T(1) - facets.B() * loss(w));
    }

    constexpr backscatter<T> backscattered() const { return facets.backscattered(); }

private:
    friend diffuse_brdf<fon, S, Sampler>;

    template <class Mask>
    constexpr S pi_f(const vec3<T>& v, const vec3<T>& l, const Mask& lit, const T& factor) const {
        return rho * select(lit, facets(v, l) * factor, T(0));
    }

    S rho;
    detail::fujii<T> facets;
};

}  // namespace lobe
