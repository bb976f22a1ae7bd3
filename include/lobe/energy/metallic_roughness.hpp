// The metallic-roughness material with all its energy.
#pragma once

#include <lobe/brdf/metallic_roughness.hpp>
#include <lobe/energy/smith_multiscatter.hpp>

namespace lobe {

/// glTF's material as its specification means it, a metal and a dielectric mixed by `metallic`, each with its later
/// bounces, and with a diffuse base that gets what the interface leaves:
///   f = metallic (f_1 + f_ms)(F0 = base_color) + (1 - metallic) ((f_1 + f_ms)(F0 = 0.04) + f_base)
///   f_base = base_color (1 - T(v)) (1 - T(l))/(pi (1 - T_avg)),  T: all bounces at F0 = 0.04
/// The last argument is what tells it from `metallic_roughness` of glTF's own coupling, whose white furnace is up to
/// 1.9. Reciprocal. Sampled as a `sum` of four lobes.
/// A white base returns all light at every `metallic`, to the error of the table and 1e-3 (T_avg in closed form; by
/// quadrature to 1e-5).
/// Parameters as there; alpha isotropic.
template <class S, scalar T, class Terms, bool Forward, bool ByQuadrature>
constexpr auto metallic_roughness(const S& base_color, const typename alpha<T>::scalar& metallic, const alpha<T>& a,
                                  const smith_multiscatter<Terms, Forward, ByQuadrature>& model) {
    assert(detail::in_unit_interval(base_color) && "metallic_roughness: the base colour must be in [0,1]");
    assert(detail::in_unit_interval(metallic) && "metallic_roughness: metallic must be in [0,1]");
    const S dielectric_F0 = S(T(4) / T(100));
    const T dielectric = T(1) - metallic;
    // the first bounce is linear in F0: one lobe for both
    const schlick F{S(dielectric_F0 * dielectric + base_color * metallic)};
    const microfacet first{ggx<T>{a}, smith_correlated{}, F};
    const auto of_first = model.energy(F, a), of_dielectric = model.energy(schlick{dielectric_F0}, a);
    const detail::first_bounce<std::decay_t<decltype(of_first)>> albedo{of_first};
    const reciprocal_coupling left{detail::all_bounces<std::decay_t<decltype(of_dielectric)>>{of_dielectric},
                                   of_dielectric.total_average()};
    return sum{detail::of_albedo(first, albedo), weighted{metallic, model.lobe(schlick{base_color}, a)},
               weighted{dielectric, model.lobe(schlick{dielectric_F0}, a)},
               weighted{dielectric, coupled{lambert{base_color}, left}}};
}

}  // namespace lobe
