// Index of refraction to the reflectance at normal incidence, and back.
#pragma once

#include <lobe/core/spectrum.hpp>

#include <cassert>

namespace lobe {

/// F0 = ((eta - 1)/(eta + 1))^2: Fresnel's equations at normal incidence (Born & Wolf, section 1.5).
/// eta: index relative to the medium outside, n_inside/n_outside (glass in water: 1.5/1.33).
/// One number or vec3; eta > 0. eta and 1/eta have the same F0.
/// Error: 7 ULP.
template <class S>
constexpr S f0_from_ior(const S& eta) {
    using T = component_t<S>;
    assert(detail::every([](const T& x) { return x > T(0); }, eta) && "f0_from_ior: eta must be above 0");
    const S r = (eta - S(T(1))) / (eta + S(T(1)));
    return r * r;
}

/// eta = (1 + sqrt(F0))/(1 - sqrt(F0)), the one of the two that is >= 1, relative to the medium outside.
/// F0 in [0,1). Error: 4 ULP over 1 - sqrt(F0), which is what F0 near 1 says about eta.
template <class S>
constexpr S ior_from_f0(const S& F0) {
    using T = component_t<S>;
    assert(detail::every([](const T& x) { return x >= T(0) && x < T(1); }, F0) && "ior_from_f0: F0 must be in [0,1)");
    return detail::by_component(
        [](const T& x) {
            using std::sqrt;
            const T r = sqrt(x);
            return (T(1) + r) / (T(1) - r);
        },
        F0);
}

}  // namespace lobe
