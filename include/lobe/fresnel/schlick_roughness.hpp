// Schlick's approximation with a grazing reflectance that falls with roughness.
#pragma once

#include <lobe/core/spectrum.hpp>
#include <lobe/fresnel/schlick.hpp>

namespace lobe {

/// F(u) = F0 + (max(1 - r, F0) - F0) (1 - u)^5: Schlick with F90 = max(1 - r, F0). Lagarde 2011, "Adopting a physically
/// based shading model". F0 in [0,1], one number or vec3 (linear); r, the artists' roughness (alpha = r^2), in [0,1]. A
/// heuristic for what the specular lobe leaves to a diffuse base, with u = n.v. It is no reflectance for a microfacet
/// BRDF, nor for the split-sum terms, which hold the grazing Fresnel already: there it adds up to 0.26 to the albedo.
/// F0 <= F <= max(1 - r, F0). `average()` is exact. Rounding: 8 ULP.
template <class S>
class schlick_roughness : public schlick<S, S> {
    using T = component_t<S>;

public:
    constexpr schlick_roughness(const S& reflectance_0, const T& roughness)
        : schlick<S, S>(reflectance_0,
                        detail::by_component([&](const T& x) { return larger(T(1) - roughness, x); }, reflectance_0)) {
        assert(detail::in_unit_interval(roughness) && "schlick_roughness: roughness must be in [0,1]");
    }
};

}  // namespace lobe
