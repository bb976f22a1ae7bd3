// The metallic-roughness material of glTF 2.0.
#pragma once

#include <lobe/brdf/lambert.hpp>
#include <lobe/brdf/layered.hpp>
#include <lobe/ndf/ggx.hpp>

namespace lobe {

/// f = F(v.h) D G2/(4 cos_v cos_l) + (1 - F(v.h)) c_diff/pi: GGX, height-correlated Smith, Schlick with
///   F0 = lerp(0.04, base_color, metallic),  c_diff = base_color (1 - metallic).
/// glTF 2.0 specification (Khronos 2021), appendix B. base_color: linear, in [0,1], one number or rgb;
/// metallic in [0,1]; width: `alpha` of roughness^2, or `alpha_xy`. f in 1/sr. It is a `layered` and samples like one.
/// Metallic 1 is the bare lobe, to the bit in f.
/// Reciprocal. Its coupling gains energy: see `fresnel_coupling`.
template <class S, class Width>
constexpr auto metallic_roughness(const S& base_color, const typename Width::scalar& metallic, const Width& width) {
    using T = typename Width::scalar;
    assert(detail::in_unit_interval(base_color) && "metallic_roughness: the base colour must be in [0,1]");
    assert(detail::in_unit_interval(metallic) && "metallic_roughness: metallic must be in [0,1]");
    const schlick F{S(S(T(4) / T(100)) * (T(1) - metallic) + base_color * metallic)};
    return layered{microfacet{ggx<T, Width>{width}, smith_correlated{}, F}, lambert{S(base_color * (T(1) - metallic))},
                   fresnel_coupling{F}};
}

/// The same from glTF's roughness in [0,1]: alpha = max(roughness^2, floor), because textures contain 0.
template <class S, scalar T>
constexpr auto metallic_roughness(const S& base_color, const T& metallic, const T& roughness, const T& floor) {
    return metallic_roughness(base_color, metallic, alpha<T>::from_roughness(roughness, floor));
}

}  // namespace lobe
