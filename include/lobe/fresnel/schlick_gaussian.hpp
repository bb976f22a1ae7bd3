// Schlick's approximation with its power replaced by an exponential: one exp2 on hardware that has it.
#pragma once

#include <lobe/core/spectrum.hpp>
#include <lobe/fresnel/schlick.hpp>

namespace lobe {

/// F(u) = F0 + (F90 - F0) 2^((-5.55473 u - 6.98316) u). Lagarde 2012, "Spherical Gaussian
/// approximation for Blinn-Phong, Phong and Fresnel"; Karis 2013, "Real Shading in Unreal Engine 4".
/// Spectrum and domains are those of `schlick`.
/// Error against `schlick`: 0.0038 (F90 - F0) at u = 0.055; F(1) is F0 + 1.7e-4 (F90 - F0). Rounding: 8 ULP.
/// `exp2` is found by ADL. On a CPU it costs more than Schlick's four products, not less.
template <class S, class F90 = unit>
class schlick_gaussian {
public:
    constexpr explicit schlick_gaussian(const S& reflectance_0, const F90& reflectance_90 = {})
        : f0(reflectance_0), f90(reflectance_90) {
        assert(detail::in_unit_interval(f0) && "schlick_gaussian: F0 must be in [0,1]");
        if constexpr (!std::same_as<F90, unit>)
            assert(detail::in_unit_interval(f90) && "schlick_gaussian: F90 must be in [0,1]");
    }

    template <detail::component_of<S> T>
    constexpr S operator()(const T& u) const {
        using std::exp2;
        return f0 + (grazing() - f0) * T(exp2((detail::constant<T>(-5.55473) * u + detail::constant<T>(-6.98316)) * u));
    }

    /// 2 int_0^1 F(u) u du = F0 + 0.0488637... (F90 - F0): Schlick's 1/21 is 0.0476190.
    constexpr S average() const {
        return f0 + (grazing() - f0) * detail::constant<component_t<S>>(0.04886370755848758);
    }

    constexpr S F0() const { return f0; }

private:
    constexpr S grazing() const {
        if constexpr (std::same_as<F90, unit>)
            return S(component_t<S>(1));
        else
            return f90;
    }

    S f0;
    [[no_unique_address]] F90 f90;
};

}  // namespace lobe
