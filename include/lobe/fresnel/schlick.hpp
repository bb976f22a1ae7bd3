// Schlick's approximation, and the perfect reflector.
#pragma once

#include <lobe/core/spectrum.hpp>

#include <cassert>

namespace lobe {

/// A reflectance of 1 that takes no room: F90 of almost everything.
struct unit {};

/// F(u) = F0 + (F90 - F0) (1 - u)^5, u = v.h. Schlick 1994, "An Inexpensive BRDF Model for Physically-based Rendering",
/// eq. 15. S is the spectrum: one number, vec3 (linear rgb) or any type with S(T), + - * and S*T.
/// F0, F90 in [0,1]; u in [0,1].
/// Error against Fresnel's equations, largest near u = 0.1: up to 0.06 for dielectrics of eta from 1.33 to 2,
/// more beyond (eta 1.2: 0.11, 1.1: 0.21, 1.01: 0.55; 2.5: 0.08, 4: 0.20); 0.18 for iron's green.
/// Rounding: 8 ULP where F90 >= F0.
template <class S, class Grazing = unit>
class schlick {
public:
    constexpr explicit schlick(const S& reflectance_0, const Grazing& reflectance_90 = {})
        : f0(reflectance_0), f90(reflectance_90) {
        assert(detail::in_unit_interval(f0) && "schlick: F0 must be in [0,1]");
        if constexpr (!std::same_as<Grazing, unit>)
            assert(detail::in_unit_interval(f90) && "schlick: F90 must be in [0,1]");
    }

    template <detail::component_of<S> T>
    constexpr S operator()(const T& u) const {
        const T w = T(1) - u;
        const T w2 = w * w;
        return f0 + (F90() - f0) * (w2 * w2 * w);
    }

    /// 2 int_0^1 F(u) u du = (20 F0 + F90)/21.
    constexpr S average() const {
        using T = component_t<S>;
        return f0 * (T(20) / T(21)) + F90() * (T(1) / T(21));
    }

    constexpr S F0() const { return f0; }
    constexpr S F90() const {
        if constexpr (std::same_as<Grazing, unit>)
            return S(component_t<S>(1));
        else
            return f90;
    }

private:
    S f0;
    [[no_unique_address]] Grazing f90;
};

/// F = 1: what the white furnace and every albedo of the microsurface alone assume. S is the spectrum;
/// `perfect_reflector{}` answers in the type of the cosine, and its average is a double.
template <class S = void>
struct perfect_reflector {
    template <detail::component_of<S> T>
    constexpr S operator()(const T&) const {
        return average();
    }
    constexpr S average() const { return S(component_t<S>(1)); }
};
template <>
struct perfect_reflector<void> {
    template <scalar T>
    constexpr T operator()(const T&) const {
        return T(1);
    }
    constexpr double average() const { return 1; }
};

}  // namespace lobe
