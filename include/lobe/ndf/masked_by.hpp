// The normals of one distribution under the masking of another.
#pragma once

#include <lobe/ndf/concepts.hpp>

namespace lobe {

/// D and the sampling of normals from `first`, projected area and Lambda from `other`: what practice does where D has
/// no closed masking, as Walter et al. 2007, p. 7, for Phong's D under Beckmann's. Not a surface: the projected area is
/// not that of D's facets, so energy is not conserved exactly, in either direction, and the visible normals of neither
/// have the density max(0, v.m) D(m)/sigma(v). Sample it with `all_normals`.
template <normal_density First, distribution Other>
    requires std::same_as<typename First::scalar, typename Other::scalar>
class masked_by {
    using T = typename First::scalar;

public:
    using scalar = T;
    static constexpr bool isotropic = First::isotropic && Other::isotropic;

    constexpr masked_by(const First& of_normals, const Other& of_masking) : first(of_normals), other(of_masking) {}

    constexpr T D(const vec3<T>& m) const { return first.D(m); }
    constexpr T projected_area(const vec3<T>& v) const { return other.projected_area(v); }
    constexpr T lambda(const vec3<T>& v) const { return other.lambda(v); }
    constexpr vec2<T> width() const { return first.width(); }

    constexpr vec3<T> sample(const vec2<T>& u) const requires samplable_density<First> { return first.sample(u); }
    constexpr T pdf(const vec3<T>& m) const { return first.D(m) * m.z; }

private:
    [[no_unique_address]] First first;
    [[no_unique_address]] Other other;
};

}  // namespace lobe
