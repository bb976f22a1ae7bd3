// Schlick's approximation with the dip that metals have near grazing, as a tint at 82 degrees.
#pragma once

#include <lobe/core/spectrum.hpp>
#include <lobe/fresnel/schlick.hpp>

namespace lobe {

/// F(u) = max(0, Schlick(u) - b u (1 - u)^6),  b = Schlick(1/7) (1 - t) 7^7/6^6.
/// So F(1/7) = t Schlick(1/7), at acos(1/7) = 82 degrees, where u (1 - u)^6 is largest; t = 1 is Schlick's.
/// Hoffman 2019, "Fresnel Equations Considered Harmful"; Kutz, Hasan & Edmondson 2021, "Novel Aspects of the Adobe
/// Standard Material". F0, t in [0,1], one number or vec3 (linear); u in [0,1].
/// Error against Fresnel's equations, t fitted: gold, silver and copper at most 0.017 (Schlick 0.040), aluminium
/// 0.022 (0.130), iron 0.019 (0.179); dielectrics gain little (eta 1.5: 0.028 for 0.036). Rounding: 4 ULP of 1.
/// The clamp acts for 7.6 % of all (F0, t), only where t <= 0.51; unclamped F falls to -0.127.
template <class S>
class f82_tint {
    using T = component_t<S>;

public:
    using scalar = T;
    using spectrum = S;

    constexpr f82_tint(const S& reflectance_0, const S& tint)
        : base(reflectance_0), b(base(T(1) / T(7)) * (S(T(1)) - tint) * (T(823543) / T(46656))) {
        assert(detail::in_unit_interval(tint) && "f82_tint: the tint must be in [0,1]");
    }

    // (Inlined by force: docs/design.md.)
    template <std::same_as<T> U>
    [[gnu::always_inline]] constexpr S operator()(const U& u) const {
        const T w = T(1) - u, w3 = w * w * w;
        return detail::by_component([](const T& x) { return larger(x, T(0)); }, base(u) - b * (u * w3 * w3));
    }

    /// (20 F0 + 1)/21 - b/126, at least 0: 2 int_0^1 F(u) u du, exact where the clamp of F does not act. Where it does
    /// this is too small, by 0.0164 at most (F0 = 0.02, t = 0).
    constexpr S average() const {
        return detail::by_component([](const T& x) { return larger(x, T(0)); }, base.average() - b / T(126));
    }

    constexpr S F0() const { return base.F0(); }

private:
    schlick<S> base;
    S b;
};

/// The F82-tint that has F0 and the reflectance at 82 degrees of an exact Fresnel reflectance, such as a `conductor`:
/// t = F(1/7)/Schlick(1/7), at most 1.
template <class F>
constexpr f82_tint<typename F::spectrum> fit_f82_tint(const F& exact) {
    using S = typename F::spectrum;
    using T = typename F::scalar;
    const S F0 = exact(T(1));
    return {F0, detail::by_component([](const T& t) { return smaller(t, T(1)); },
                                     exact(T(1) / T(7)) / schlick<S>(F0)(T(1) / T(7)))};
}

}  // namespace lobe
