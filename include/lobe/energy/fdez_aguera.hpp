// Multiple scattering for image-based light, from the split-sum terms alone.
#pragma once

#include <lobe/energy/multiple_scattering.hpp>
#include <lobe/fresnel/schlick.hpp>

namespace lobe {

/// Fdez-Aguera 2019, "A Multiple-Scattering Microfacet Model for Real-Time Image Based Lighting", eq. 16-18 (the
/// equations; the published listing counts the grazing Fresnel twice).
///   FssEss = F0 scale + F90 bias,  Ems = 1 - (scale + bias),  Fms = FssEss Favg / (1 - Favg Ems),  Favg = (20 F0 +
///   F90)/21
///   conductor:  radiance = FssEss,  irradiance = Fms Ems
///   dielectric: ... + albedo (1 - FssEss - Fms Ems): what the specular lobe leaves, reflected by a diffuse base
/// `irradiance` means irradiance/pi, as irradiance maps store it. F0, albedo in [0,1], linear; F90 as in `schlick`: 1
/// for `fdez_aguera{}`, a spectrum for `fdez_aguera{F90}`.
/// Not reciprocal: at F0 = 0.9, alpha 0.5, by 30 % for cosines from 0.1, 40 % from 0.05, more at larger alpha. Albedo
/// against the random walk, mu from 0.05, alpha from 0.1: within 0.020, 0.021, 0.042, 0.060 at F0 = 0.04, 0.2, 0.5,
/// 0.9. Darker where smooth surfaces are seen at grazing angles, whose later bounces reflect far more than Favg: at F0
/// = 0.04 by 0.062 at roughness 0.02, mu = 0.001, by 0.074 at mu = alpha = 0.01, by 0.099 as mu = alpha vanishes
/// (0.084, 0.054 at F0 = 0.2, 0.5). S also needs a division.
template <class F90 = unit>
class fdez_aguera {
public:
    constexpr explicit fdez_aguera(const F90& reflectance_90 = {}) : f90(reflectance_90) {}

    template <class S, scalar T>
    constexpr ibl_weights<S> operator()(const dfg_terms<T>& t, const S& F0) const {
        const schlick F{F0, f90};
        const S FssEss = F0 * t.scale + F.F90() * t.bias, Favg = F.average();
        const T Ems = T(1) - t.albedo();
        return {FssEss, FssEss * Favg * Ems / (S(T(1)) - Favg * Ems)};
    }

    template <class S, scalar T>
    constexpr ibl_weights<S> operator()(const dfg_terms<T>& t, const S& F0,
                                        const std::type_identity_t<S>& albedo) const {
        return detail::over_a_base((*this)(t, F0), albedo);
    }

private:
    [[no_unique_address]] F90 f90;
};

}  // namespace lobe
