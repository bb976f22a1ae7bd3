// Masking and shadowing: one function a model, its denominator. Smith's models, written on the projected area;
// Schlick's approximation is in schlick_ggx.hpp, V-cavities in v_cavity.hpp.
#pragma once

#include <lobe/ndf/concepts.hpp>

namespace lobe {

/// What follows from a masking model's denominator. `Model` supplies `denominator(ndf, v, l, sv)`, where sv is
/// ndf.projected_area(v), which callers usually have.
template <class Model>
struct masking_functions {
    template <distribution N, class T = typename N::scalar>
    constexpr T denominator(const N& ndf, const vec3<T>& v, const vec3<T>& l) const {
        return model().denominator(ndf, v, l, detail::area_above(ndf, v));
    }

    /// V = G2 / (4 cos(theta_v) cos(theta_l)): finite at grazing angles; v and l above the horizon.
    template <distribution N, class T = typename N::scalar>
    constexpr T visibility(const N& ndf, const vec3<T>& v, const vec3<T>& l) const {
        return T(1) / (T(4) * model().denominator(ndf, v, l));
    }

    /// The fraction of the microsurface facing both v and l that both see.
    template <distribution N, class T = typename N::scalar>
    constexpr T G2(const N& ndf, const vec3<T>& v, const vec3<T>& l) const {
        return v.z * l.z / model().denominator(ndf, v, l);
    }

    /// ... that v sees: cos(theta_v) / projected_area(v) = 1/(1 + Lambda(v)).
    /// A model whose G1 is not Smith's declares its own.
    template <distribution N, class T = typename N::scalar>
    constexpr T G1(const N& ndf, const vec3<T>& v) const {
        return v.z / detail::area_above(ndf, v);
    }

private:
    constexpr const Model& model() const { return static_cast<const Model&>(*this); }
};

/// Masking and shadowing independent of each other: G2 = G1(v) G1(l). Smith 1967; Walter et al. 2007, eq. 23.
/// Simpler than the correlated form and darker than a real height field, by up to 0.09. Error of V: 6 ULP.
struct smith_separable : masking_functions<smith_separable> {
    static constexpr bool smooth = true;
    using masking_functions::denominator;
    template <distribution N, class T = typename N::scalar>
    constexpr T denominator(const N& ndf, const vec3<T>&, const vec3<T>& l, const T& sv) const {
        return sv * detail::area_above(ndf, l);
    }
};

/// Masking and shadowing correlated through the height: G2 = 1/(1 + Lambda(v) + Lambda(l)). Ross, Dion, Potvin 2005;
/// Heitz 2014, eq. 99. The consistent default: it is what the random walk's first bounce does.
/// den = sv cos_l + sl cos_v - cos_v cos_l, grouped so that it rounds least. In the areas S = 2 s - cos that are seen
/// from both sides it is (Sv cos_l + Sl cos_v)/2: shorter, where a distribution has them and no caller has sv already.
/// Error of V: 6 ULP.
struct smith_correlated : masking_functions<smith_correlated> {
    static constexpr bool smooth = true;
    template <distribution N, class T = typename N::scalar>
    constexpr T denominator(const N& ndf, const vec3<T>& v, const vec3<T>& l) const {
        if constexpr (requires { ndf.projected_area_both(v); })
            return (ndf.projected_area_both(v) * l.z + ndf.projected_area_both(l) * v.z) / T(2);
        else
            return masking_functions::denominator(ndf, v, l);
    }
    template <distribution N, class T = typename N::scalar>
    constexpr T denominator(const N& ndf, const vec3<T>& v, const vec3<T>& l, const T& sv) const {
        return sv * l.z + (detail::area_above(ndf, l) - l.z) * v.z;
    }
};

/// Masking and shadowing correlated through the height and the azimuth phi between v and l:
///   G2 = 1/(1 + max(Lambda_v, Lambda_l) + lambda(phi) min(Lambda_v, Lambda_l)),  lambda = 4.41 phi/(4.41 phi + 1).
/// lambda: van Ginneken, Stavridi, Koenderink 1998, "Diffuse and Specular Reflectance from Rough Surfaces";
/// used so by Heitz 2014. phi = 0 gives min(G1(v), G1(l)): what v sees is lit. phi = pi comes near smith_correlated,
/// from above, without reaching it: lambda(pi) = 0.9327. At v or l = n the azimuth does not matter: Lambda is 0 there.
///   den = max(sv cos_l, sl cos_v) + lambda min((sv - cos_v) cos_l, (sl - cos_l) cos_v)
/// v, l unit, above the horizon. Calls `atan2`, so a loop vectorises only where there is a vector atan2.
/// Error: 6 ULP.
struct smith_direction_correlated : masking_functions<smith_direction_correlated> {
    using masking_functions::denominator;
    template <distribution N, class T = typename N::scalar>
    constexpr T denominator(const N& ndf, const vec3<T>& v, const vec3<T>& l, const T& sv) const {
        using std::atan2;
        const T sl = detail::area_above(ndf, l);
        const T along = v.x * l.x + v.y * l.y, across = v.x * l.y - v.y * l.x;
        const auto no_azimuth = equal(along, T(0)) && equal(across, T(0));
        const T phi = atan2(absolute(across), select(no_azimuth, T(1), along));
        const T lambda = T(441) * phi / (T(441) * phi + T(100));
        return larger(sv * l.z, sl * v.z) + lambda * smaller((sv - v.z) * l.z, (sl - l.z) * v.z);
    }
};

/// smith_correlated of GGX without its square roots: S(w), which is sqrt(alpha^2 + (1 - alpha^2) cos^2),
/// becomes alpha + (1 - alpha) cos, so that V = 1/(2 lerp(2 cos_v cos_l, cos_v + cos_l, alpha)).
/// Hammon 2017, "PBR Diffuse Lighting for GGX+Smith Microsurfaces"; Filament, `V_SmithGGXCorrelatedFast`.
/// alpha = ndf.width().x: isotropic distributions only, as there is no form for two widths; any of them, but what it
/// approximates is GGX. 0 < alpha <= 1.
/// Error against smith_correlated: G2 too dark by up to 0.233, where both cosines are 1.6 alpha and alpha is small;
/// never too bright; exact at alpha = 1. Rounding: 4 ULP.
struct smith_hammon : masking_functions<smith_hammon> {
    static constexpr bool smooth = true;
    using masking_functions::denominator;
    template <distribution N, class T = typename N::scalar>
        requires(N::isotropic)
    constexpr T denominator(const N& ndf, const vec3<T>& v, const vec3<T>& l, const T&) const {
        const T a = ndf.width().x;
        return (T(1) - a) * (v.z * l.z) + a * (v.z + l.z) / T(2);
    }

    /// G2(v, n): Schlick's approximation with k = alpha/2.
    template <distribution N, class T = typename N::scalar>
        requires(N::isotropic)
    constexpr T G1(const N& ndf, const vec3<T>& v) const {
        const T k = ndf.width().x / T(2);
        return v.z / (v.z * (T(1) - k) + k);
    }
};

/// A masking model for the distribution N.
template <class M, class N>
concept masking = distribution<N> && requires(const M model, const N ndf, const vec3<typename N::scalar> w) {
    { model.denominator(ndf, w, w) } -> std::same_as<typename N::scalar>;
    { model.denominator(ndf, w, w, w.z) } -> std::same_as<typename N::scalar>;
};

}  // namespace lobe
