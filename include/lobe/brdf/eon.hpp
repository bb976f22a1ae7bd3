// EON: the rough diffuse reflector that keeps its energy.
#pragma once

#include <lobe/brdf/oren_nayar.hpp>

namespace lobe {

/// f = f_FON + rho_ms/pi (1 - E_F(v)) (1 - E_F(l)) / (1 - E_avg), rho_ms = rho^2 E_avg / (1 - rho (1 - E_avg)).
/// Portsmouth, Kutz, Hill 2024, "EON: A practical energy-preserving rough diffuse BRDF", listing 1. With 1 - E_F = r
/// A_F loss and 1 - E_avg = r A_F (c1 - c2) the quotient is r A_F loss(v) loss(l)/(c1 - c2), which is no 0/0
/// at r = 0. rho, r in [0,1]; r = 0 is Lambert. `Loss`: `fon_loss`, or `fon_loss_fit`, which needs no inverse tangent.
/// A spectrum of the user's own needs `/` here, once, in the constructor.
/// Reciprocal. Albedo 1 at rho = 1, within 4e-4 with the fit. Rounding: 8 ULP of its largest term.
/// Sampled by `backscatter_sampling`: weight at most 1.16 rho. `eon{rho, r, fon_loss{}, cosine_sampling{}}`:
/// 0.78 rho/cos(theta_v).
template <class S, class Loss = fon_loss, class Sampler = backscatter_sampling>
class eon : public diffuse_brdf<eon<S, Loss, Sampler>, S, Sampler> {
    using T = component_t<S>;
    static_assert(
        requires(const Loss loss, const vec3<T> w) {
            { loss(w) } -> std::convertible_to<T>;
        },
        "the third part of EON is what FON loses, a callable of a direction; the sampler is the fourth");

public:
    constexpr eon(const S& albedo, const T& roughness, const Loss& loss_of_fon = {}, const Sampler& = {})
        : rho(albedo), rho_ms(albedo), facets(roughness), loss(loss_of_fon) {
        assert(detail::in_unit_interval(rho) && "eon: the albedo must be in [0,1]");
        const T c = T(6) / T(5) * inv_pi<T>() - T(1) / T(6), E_avg = facets.average_albedo();  // c = c1 - c2
        rho_ms = rho * rho * (E_avg * facets.B() / c) / (S(T(1)) - rho * (facets.B() * c));
    }

    constexpr backscatter<T> backscattered() const { return facets.backscattered(); }

private:
    friend diffuse_brdf<eon, S, Sampler>;

    template <class Mask>
    constexpr S pi_f(const vec3<T>& v, const vec3<T>& l, const Mask& lit, const T& factor) const {
        return rho * select(lit, facets(v, l) * factor, T(0)) + rho_ms * select(lit, loss(v) * loss(l) * factor, T(0));
    }

    S rho, rho_ms;  // the latter times r A_F/(c1 - c2)
    detail::fujii<T> facets;
    [[no_unique_address]] Loss loss;
};

}  // namespace lobe
