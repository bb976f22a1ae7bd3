// Multiple scattering for image-based light, from the split-sum terms alone.
#pragma once

#include <lobe/energy/dfg.hpp>

namespace lobe {

/// What to multiply the prefiltered radiance and the irradiance/pi with.
template <class S>
struct ibl_weights {
    S radiance, irradiance;
};

/// Fdez-Aguera 2019, "A Multiple-Scattering Microfacet Model for Real-Time Image Based Lighting", eq. 16-18 (the equations;
/// the published listing counts the grazing Fresnel twice).
///   FssEss = F0 scale + bias,  Ems = 1 - (scale + bias),  Fms = FssEss Favg / (1 - Favg Ems),  Favg = (20 F0 + 1)/21
///   conductor:  radiance = FssEss,  irradiance = Fms Ems
///   dielectric: ... + albedo (1 - FssEss - Fms Ems): what the specular lobe leaves, reflected by a diffuse base
/// `irradiance` means irradiance/pi, as irradiance maps store it. F0, albedo in [0,1], linear.
/// Not reciprocal: at F0 = 0.9, alpha 0.5, by 30 % for cosines from 0.1, 40 % from 0.05, more at larger alpha.
/// Albedo against the random walk, mu from 0.05, alpha from 0.1: within 0.020, 0.021, 0.042, 0.060 at F0 = 0.04, 0.2, 0.5, 0.9.
/// Darker where smooth surfaces are seen at grazing angles, whose later bounces reflect far more than Favg: at F0 = 0.04 by 0.062
/// at roughness 0.02, mu = 0.001, by 0.074 at mu = alpha = 0.01, by 0.099 as mu = alpha vanishes (0.084, 0.054 at F0 = 0.2, 0.5).
/// S also needs a division.
struct fdez_aguera {
    template <class S, scalar T>
    constexpr ibl_weights<S> operator()(const dfg_terms<T>& t, const S& F0) const {
        const S FssEss = F0 * t.scale + S(t.bias);
        const S Favg = (F0 * T(20) + S(T(1))) * (T(1) / T(21));
        const T Ems = T(1) - t.albedo();
        return {FssEss, FssEss * Favg * Ems / (S(T(1)) - Favg * Ems)};
    }

    template <class S, scalar T>
    constexpr ibl_weights<S> operator()(const dfg_terms<T>& t, const S& F0, const std::type_identity_t<S>& albedo) const {
        const ibl_weights<S> specular = (*this)(t, F0);
        return {specular.radiance, specular.irradiance + albedo * (S(T(1)) - specular.radiance - specular.irradiance)};
    }
};

}  // namespace lobe
