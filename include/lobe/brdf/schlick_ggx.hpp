// Schlick's approximation of Smith's masking, and every convention for its constant k by name.
#pragma once

#include <lobe/brdf/masking.hpp>

#include <cassert>

namespace lobe {

/// The constant k of `schlick_ggx`, as a type: no bare number is taken for it, because the literature gives the letter
/// four meanings. The functions below name them; this constructor is for a convention of your own.
/// Precondition: k >= 0.
template <scalar T>
class schlick_k {
public:
    using scalar = T;
    constexpr explicit schlick_k(const T& value) : k(value) {
        assert(all(k >= T(0)) && "schlick_k: k must not be negative");
    }
    constexpr T value() const { return k; }

private:
    T k;
};

/// k = alpha/2: the approximation of Smith-GGX. Karis 2013, "Real Shading in Unreal Engine 4", before his remapping for
/// punctual lights. Error of G1 against GGX: 0.163 at most, 0.050 rms (roughness 0.05 to 1); exact at alpha = 1.
template <scalar T>
constexpr schlick_k<T> k_from_alpha(const alpha<T>& a) {
    return schlick_k<T>(a.value() / T(2));
}

/// k = r^2/2, r the artists' roughness in [0,1]: the same number as `k_from_alpha`, since alpha = r^2. Karis 2013, for
/// image-based light. Tutorials print it as "k = alpha^2/2" and mean r by alpha there; read with alpha = r^2 it becomes
/// r^4/2, whose G1 is wrong by up to 0.90 (0.78 for cosines from 0.001).
template <scalar T>
constexpr schlick_k<T> k_ibl(const T& roughness) {
    assert(all(roughness >= T(0)) && "schlick_k: roughness must not be negative");
    return schlick_k<T>(roughness * roughness / T(2));
}

/// k = (r + 1)^2/8, r the artists' roughness in [0,1]. Karis 2013, for punctual lights: an artistic remapping
/// (of r to (r + 1)/2 before it is squared), no approximation of Smith-GGX, whose G1 it misses by up to 0.92, 0.20 rms.
/// Never for image-based light.
template <scalar T>
constexpr schlick_k<T> k_ue4_direct(const T& roughness) {
    assert(all(roughness >= T(0)) && "schlick_k: roughness must not be negative");
    const T r = roughness + T(1);
    return schlick_k<T>(r * r / T(8));
}

/// k = sqrt(2/pi) m, m the root mean square slope (alpha/sqrt(2) for Beckmann): Schlick's own, for Beckmann's masking.
/// Schlick 1994, "An Inexpensive BRDF Model for Physically-based Rendering".
/// Error of G1 against GGX at m = alpha/sqrt(2):
/// 0.189 at most, 0.064 rms.
template <scalar T>
constexpr schlick_k<T> k_schlick1994(const T& rms_slope) {
    using std::sqrt;
    assert(all(rms_slope >= T(0)) && "schlick_k: the rms slope must not be negative");
    return schlick_k<T>(sqrt(T(2) * inv_pi<T>()) * rms_slope);
}

/// G1(w) = cos/(cos (1 - k) + k), G2 = G1(v) G1(l): den = (cos_v (1 - k) + k) (cos_l (1 - k) + k). Schlick 1994.
/// For any distribution: k alone knows the width. v, l unit, above the horizon. Error: see each k; rounding 6 ULP.
template <scalar T>
class schlick_ggx : public masking_functions<schlick_ggx<T>> {
public:
    constexpr explicit schlick_ggx(const schlick_k<T>& constant) : k(constant) {}

    using masking_functions<schlick_ggx>::denominator;
    template <distribution N>
        requires std::same_as<T, typename N::scalar>
    constexpr T denominator(const N&, const vec3<T>& v, const vec3<T>& l, const T&) const {
        return area(v.z) * area(l.z);
    }

    template <distribution N>
        requires std::same_as<T, typename N::scalar>
    constexpr T G1(const N&, const vec3<T>& v) const { return v.z / area(v.z); }

private:
    // in the place of projected_area
    constexpr T area(const T& cosine) const { return cosine * (T(1) - k.value()) + k.value(); }

    schlick_k<T> k;
};

}  // namespace lobe
